#include "core/adaptive/sample_allocation.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace abbe;

namespace {

constexpr int kWidth = 60, kHeight = 40;
constexpr PixelWindow kWindow{7, 3, 7 + kWidth, 3 + kHeight};

/// Two samples in each pixel, 1 - d and 1 + d times a grey (the white of sRGB has R = G = B): the
/// estimated error is d times the grey.
Film film_of(const std::function<double(int, int)>& grey,
             const std::function<double(int, int)>& d) {
  Film film(kWindow, 0x1p-40, 0, true);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (const std::uint32_t i : {0u, 1u}) {
        const double v = grey(x, y) * (1.0 + (i == 0 ? -1.0 : 1.0) * d(x, y));
        film.add({kWindow.x0 + x, kWindow.y0 + y, i, true}, to_xyz(LinearRgb{v, v, v}), {});
      }
  return film;
}

double one(int, int) {
  return 1.0;
}

/// From 1 to 4 down the picture. Numbers of samples are rounded to powers of two; over two octaves
/// of errors that averages out.
double octaves(int y) {
  return std::exp2(y * 2.0 / kHeight);
}

/// 3 for each of two samples: they cost 4.
std::vector<std::uint32_t> equal_rays() {
  return std::vector<std::uint32_t>(kWindow.pixel_count(), 6);
}

/// The mean over columns [first, last).
double mean_of(const std::vector<std::uint32_t>& samples, int first, int last) {
  double sum = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = first; x < last; ++x)
      sum += samples[static_cast<std::size_t>(y * kWidth + x)];
  return sum / ((last - first) * kHeight);
}

} // namespace

// Borders are geometric means: sqrt(2), sqrt(8) = 2.828, sqrt(32) = 5.657.
TEST_CASE("the nearest power of two, by ratio") {
  const auto check = [](double wanted, std::uint32_t count) {
    INFO(wanted);
    CHECK(nearest_power_of_two(wanted) == count);
  };
  check(-1.0, 1);
  check(0.2, 1);
  check(1.41, 1);
  check(1.42, 2);
  check(2.0, 2);
  check(2.82, 2);
  check(2.83, 4);
  check(4.0, 4);
  check(5.65, 4);
  check(5.66, 8);
  check(100.0, 128);
  check(4096.0, 4096);
}

// Shares of 1/2.5 + 0.1 and 4/2.5 + 0.1 of the mean. The two halves meet within two pixels.
TEST_CASE("samples are in proportion to the error, with a floor") {
  const Film film =
      film_of(one, [](int x, int y) { return (x < kWidth / 2 ? 0.05 : 0.2) * octaves(y); });
  const auto samples = allocate_samples(film, equal_rays(), 200.0);
  CHECK(mean_of(samples, 0, kWidth) == Approx(200.0).epsilon(0.01));
  const double quiet = mean_of(samples, 0, 28), noisy = mean_of(samples, 32, kWidth);
  CHECK(noisy / quiet == Approx(1.7 / 0.5).epsilon(0.1));
}

// The same error of a grey 100. The mean is 50.5, 0.01 m^2 = 25.5: variances in proportion to
// 1 / 26.5 and 1 / 10025.5, shares as 1 to 0.0514. (Without the second term as 1 to 0.01.)
TEST_CASE("errors count in relation to the pixel and to the picture's mean") {
  const auto grey = [](int x, int) { return x < kWidth / 2 ? 1.0 : 100.0; };
  const Film film = film_of(grey, [&](int x, int y) { return 0.2 * octaves(y) / grey(x, y); });
  const auto samples = allocate_samples(film, equal_rays(), 300.0);
  const double ratio = mean_of(samples, 0, 28) / mean_of(samples, 32, kWidth);
  CHECK(ratio == Approx((1.0 / 0.5257 + 0.1) / (0.0514 / 0.5257 + 0.1)).epsilon(0.1));
}

TEST_CASE("what costs four times as much gets half as many samples") {
  const Film film = film_of(one, [](int, int y) { return 0.1 * octaves(y); });
  std::vector<std::uint32_t> rays(kWindow.pixel_count());
  for (std::size_t i = 0; i < rays.size(); ++i)
    rays[i] = static_cast<int>(i) % kWidth < kWidth / 2 ? 2 : 14; // and one more each: 2 and 8
  const auto samples = allocate_samples(film, rays, 200.0);
  CHECK(mean_of(samples, 0, kWidth) == Approx(200.0).epsilon(0.01));
  const double cheap = mean_of(samples, 0, 28), dear = mean_of(samples, 32, kWidth);
  CHECK(cheap / dear == Approx((1.0 / 0.75 + 0.1) / (0.5 / 0.75 + 0.1)).epsilon(0.1));
}

TEST_CASE("a bright sample by chance draws samples to its surroundings alone, and not all") {
  const Film film = film_of([](int x, int y) { return x == 30 && y == 20 ? 1e4 : 1.0; },
                            [](int x, int y) { return x == 30 && y == 20 ? 0.99 : 0.01; });
  const auto samples = allocate_samples(film, equal_rays(), 64.0);
  const auto at = [&](int x, int y) { return samples[static_cast<std::size_t>(y * kWidth + x)]; };
  CHECK(at(30, 20) >= 512); // eight times the mean
  CHECK(*std::max_element(samples.begin(), samples.end()) <= 512);
  CHECK(at(5, 5) >= 2);
  CHECK(mean_of(samples, 0, kWidth) <= 64.0);
}

TEST_CASE("where there is no noise at all samples are shared out evenly") {
  const Film still = film_of(one, [](int, int) { return 0.0; });
  const Film black = film_of([](int, int) { return 0.0; }, [](int, int) { return 0.0; });
  for (const Film* film : {&still, &black})
    for (const std::uint32_t n : allocate_samples(*film, equal_rays(), 23.0))
      REQUIRE(n == 23);
}

TEST_CASE("a quiet half meets the mean, not the step below it") {
  const Film film = film_of(one, [](int x, int) { return x < kWidth / 2 ? 0.0 : 0.3; });
  for (const double mean : {20.0, 64.0, 100.0, 1000.0})
    CHECK(mean_of(allocate_samples(film, equal_rays(), mean), 0, kWidth) ==
          Approx(mean).epsilon(0.02));
}

TEST_CASE("no pixel gets fewer samples than it has") {
  Film film = film_of(one, [](int x, int) { return x < kWidth / 2 ? 0.01 : 0.3; });
  for (std::uint32_t i = 2; i < 42; ++i)
    film.add({kWindow.x0, kWindow.y0, i, true}, to_xyz(LinearRgb{1.0, 1.0, 1.0}), {});
  const auto samples = allocate_samples(film, equal_rays(), 8.0);
  CHECK(samples[0] == 42);
  CHECK(*std::min_element(samples.begin(), samples.end()) >= 2);
  CHECK(mean_of(samples, 0, kWidth) == Approx(8.0).epsilon(0.02));
}

// A red that is 0 in green and blue: their errors are large in relation.
TEST_CASE("errors are those of linear red, green and blue") {
  Film film(kWindow, 0x1p-40, 0, true);
  for (int y = kWindow.y0; y < kWindow.y1; ++y)
    for (int x = kWindow.x0; x < kWindow.x1; ++x)
      for (const std::uint32_t i : {0u, 1u}) {
        const double v = (i == 0 ? -0.04 : 0.04) * octaves(y - kWindow.y0);
        const bool red = x < kWindow.x0 + kWidth / 2;
        film.add({x, y, i, true},
                 to_xyz(red ? LinearRgb{1.0 + v, 0.2, 0.2} : LinearRgb{1.0, 0.2 + v, 0.2}), {});
      }
  const auto samples = allocate_samples(film, equal_rays(), 200.0);
  // m = 1.4 / 3, 0.01 m^2 = 0.00218: sqrt(1.00218 / 0.04218) = 4.87 times the share.
  const double ratio = mean_of(samples, 32, kWidth) / mean_of(samples, 0, 28);
  CHECK(ratio == Approx((4.87 / 2.935 + 0.1) / (1.0 / 2.935 + 0.1)).epsilon(0.1));
}

// On the left red and green err in opposite ways, on the right in the same: the squares are equal.
TEST_CASE("errors keep their signs on the way from XYZ to red, green and blue") {
  Film film(kWindow, 0x1p-40, 0, true);
  for (int y = kWindow.y0; y < kWindow.y1; ++y)
    for (int x = kWindow.x0; x < kWindow.x1; ++x)
      for (const std::uint32_t i : {0u, 1u}) {
        const double v = (i == 0 ? -0.04 : 0.04) * octaves(y - kWindow.y0);
        const double w = x < kWindow.x0 + kWidth / 2 ? -v : v;
        film.add({x, y, i, true}, to_xyz(LinearRgb{0.5 + v, 0.5 + w, 0.5}), {});
      }
  const auto samples = allocate_samples(film, equal_rays(), 200.0);
  CHECK(mean_of(samples, 0, 28) == Approx(mean_of(samples, 32, kWidth)).epsilon(0.03));
}
