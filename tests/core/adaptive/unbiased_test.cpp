#include "core/adaptive/pixel_quarter.h"
#include "core/adaptive/sample_allocation.h"
#include "core/adaptive/sample_schedule.h"
#include "core/adaptive/sample_shares.h"
#include "core/sampling/sampler.h"
#include "tests/catch.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

using namespace abbe;

// The samples of pixels are simulated: the real sampler places them, and the real schedule and
// allocation tell how many there are. Expected values are areas, and the intervals are those of the
// binomial distribution.

namespace {

/// The value of a sample, by its place in the pixel.
using Image = std::function<double(int x, int y, const Sampler& sampler)>;

void add_samples(Film& film, const Image& image, std::uint64_t seed,
                 const std::function<std::uint32_t(int, int)>& wanted) {
  const PixelWindow& w = film.window();
  tbb::parallel_for(w.y0, w.y1, [&](int y) {
    for (int x = w.x0; x < w.x1; ++x)
      for (std::uint32_t i = film.samples(x, y); i < wanted(x, y); ++i) {
        const double v = image(x, y, Sampler(x, y, i, seed));
        film.add({x, y, i, true}, v > 0.0 ? to_xyz(LinearRgb{v, v, v}) : Xyz{0.0, 0.0, 0.0}, {});
      }
  });
}

Film adaptively_sampled(int size, int samples, const Image& image, std::uint64_t seed) {
  RenderSettings settings;
  settings.samples_per_pixel = samples;
  settings.adaptive = AdaptiveSampling::on;
  const SampleSchedule schedule(settings);
  Film film({0, 0, size, size}, 0x1p-40, 0, true);
  for (int done = 0; done < samples;) {
    const int end = schedule.end_of_round(done);
    std::vector<std::uint32_t> counts(film.window().pixel_count(), static_cast<std::uint32_t>(end));
    if (done > 0) {
      std::vector<std::uint32_t> rays(counts.size());
      for_each_pixel(film.window(), [&](int x, int y) {
        rays[film.window().index(x, y)] = 2 * film.samples(x, y);
      });
      counts = allocate_samples(film, find_shares(film, rays), end);
    }
    add_samples(film, image, seed, [&](int x, int y) { return counts[film.window().index(x, y)]; });
    done = end;
  }
  return film;
}

/// The mean value of the pixels, and how many samples they have in all.
struct Means {
  double value = 0.0, samples = 0.0;
};

Means means_of(const Film& film) {
  Means m;
  const auto count = static_cast<double>(film.window().pixel_count());
  for_each_pixel(film.window(), [&](int x, int y) {
    m.value += film.color(x, y).y / count;
    m.samples += film.samples(x, y);
  });
  return m;
}

} // namespace

// A light of an area p in every third pixel, along diagonals, of value 1: a sample of its
// pixel hits it with the chance p. Samples of one pixel are stratified, so that the variance is at
// most p (1 - p) / n, and those of different pixels are independent.
TEST_CASE("sparse lights keep their light under adaptive sampling") {
  constexpr int kSize = 300;
  constexpr double kLights = kSize * kSize / 3;
  const auto has_light = [](int x, int y) { return (x + y) % 3 == 0; };
  for (const double area : {0.1, 0.01, 0.001})
    for (const int samples : {8, 16, 64, 256}) {
      const double side = std::sqrt(area);
      const Image image = [&](int x, int y, const Sampler& sampler) {
        if (!has_light(x, y)) return 0.0;
        const dvec2 u = sampler.pair(kPixelPosition);
        return u.x < side && u.y < side ? 1.0 : 0.0;
      };
      double sum = 0.0, variance = 0.0, expected_hits = 0.0, films = 0.0;
      while (expected_hits < 1e4) {
        const Film film =
            adaptively_sampled(kSize, samples, image, 1 + static_cast<std::uint64_t>(films));
        for_each_pixel(film.window(), [&](int x, int y) {
          if (!has_light(x, y)) return;
          sum += film.color(x, y).y;
          variance += area * (1.0 - area) / film.samples(x, y);
          expected_hits += area * film.samples(x, y);
        });
        films += 1.0;
      }
      INFO(area << " of a pixel, " << samples << " samples, " << films
                << " films: " << sum / (films * kLights * area) << " of the light");
      CHECK(std::abs(sum - films * kLights * area) < 4.5 * std::sqrt(variance));
    }
}

// Lights of a fiftieth of a pixel's area in some pixels, on a quiet ground.
TEST_CASE("the mean of a million adaptively sampled pixels is right within a thousandth") {
  constexpr int kSize = 1000;
  const Image image = [](int x, int y, const Sampler& sampler) {
    const dvec2 u = sampler.pair(kPixelPosition);
    const bool light = (x * 5 + y * 3) % 7 == 0;
    return (light && u.x < 0.2 && u.y < 0.1 ? 10.0 : 0.0) + 0.5 * u.x;
  };
  double lights = 0.0;
  for_each_pixel(PixelWindow{0, 0, kSize, kSize},
                 [&](int x, int y) { lights += (x * 5 + y * 3) % 7 == 0 ? 1.0 : 0.0; });
  const double expected = 0.25 + 10.0 * 0.02 * lights / (kSize * kSize);
  const Means m = means_of(adaptively_sampled(kSize, 32, image, 5));
  CHECK(m.value == Approx(expected).epsilon(0.001));
  CHECK(m.samples == Approx(32.0 * kSize * kSize).epsilon(0.02));
}

// What a quarter of the pixels shows may change its own samples in nothing.
TEST_CASE("the shares of a quarter follow from the other quarters alone") {
  constexpr PixelWindow kWindow{3, 4, 43, 34};
  const auto shares = [&](std::size_t changed, double value) {
    Film film(kWindow, 0x1p-40, 0, true);
    std::vector<std::uint32_t> rays(kWindow.pixel_count());
    for_each_pixel(kWindow, [&](int x, int y) {
      const double scale = quarter_of(x, y) == changed ? value : 1.0;
      for (const std::uint32_t i : {0u, 1u, 2u, 3u}) {
        const double v =
            scale * (1.0 + (x > 20 ? 1.0 : 0.1) * (Sampler(x, y, i, 2).pair(7).x - 0.5));
        film.add({x, y, i, true}, to_xyz(LinearRgb{v, v * scale, v}), {});
      }
      rays[kWindow.index(x, y)] = static_cast<std::uint32_t>(8.0 * scale) + 4;
    });
    return find_shares(film, rays);
  };
  for (std::size_t changed = 0; changed < kQuarters; ++changed) {
    const auto before = shares(changed, 1.0), after = shares(changed, 3.0);
    std::size_t differ = 0;
    for_each_pixel(kWindow, [&](int x, int y) {
      const std::size_t i = kWindow.index(x, y);
      REQUIRE(before[i] > 0.0f);
      if (quarter_of(x, y) == changed) REQUIRE(before[i] == after[i]);
      differ += before[i] != after[i] ? 1 : 0;
    });
    CHECK(differ > kWindow.pixel_count() / 2);
  }
}

// Neighbours show nothing of lights that lie in single pixels, so all get the mean.
TEST_CASE("where neighbours tell nothing, samples are shared out evenly") {
  const Image image = [](int x, int y, const Sampler& sampler) {
    return x % 16 == 0 && y % 16 == 0 && sampler.pair(kPixelPosition).x < 0.3 ? 1.0 : 0.0;
  };
  const Film film = adaptively_sampled(256, 24, image, 3);
  for_each_pixel(film.window(), [&](int x, int y) { REQUIRE(film.samples(x, y) == 24); });
}
