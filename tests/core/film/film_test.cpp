#include "core/film/film.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace abbe;

namespace {

constexpr double kQuantum = 0x1p-40;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

Film one_pixel(int bands = 0) {
  return {{0, 0, 1, 1}, kQuantum, bands};
}

} // namespace

TEST_CASE("colours and errors do not depend on the order of the samples") {
  std::mt19937 random(1);
  std::lognormal_distribution<double> radiance(0.0, 4.0);
  std::vector<std::pair<std::uint32_t, Xyz>> samples(1000);
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    samples[i] = {i, {radiance(random), radiance(random), radiance(random)}};
  const auto sum = [&] {
    Film film({0, 0, 1, 1}, kQuantum, 0, true);
    for (const auto& [index, color] : samples)
      film.add({0, 0, index, true}, color, {});
    return film;
  };
  const Film first = sum();
  CHECK(first.strata(0, 0) == PixelStrata{512, 512});
  for (int i = 0; i < 5; ++i) {
    std::shuffle(samples.begin(), samples.end(), random);
    const Film other = sum();
    CHECK(other.color(0, 0) == first.color(0, 0));
    CHECK(other.signed_error(0, 0) == first.signed_error(0, 0));
    CHECK(other.strata(0, 0) == first.strata(0, 0));
  }
}

TEST_CASE("a film gives means of colour, bands and coverage, per pixel of its window") {
  Film film({10, 20, 13, 22}, kQuantum, 2);
  const std::vector<float> dim{0.25f, 0.5f}, bright{0.75f, 1.5f};
  film.add({12, 21, 0, true}, {0.1, 0.2, 0.3}, dim);
  film.add({12, 21, 1, false}, {0.3, 0.4, 0.5}, bright);
  const Xyz mean = film.color(12, 21);
  CHECK(mean.x == Approx(0.2).margin(kQuantum));
  CHECK(mean.y == Approx(0.3).margin(kQuantum));
  CHECK(mean.z == Approx(0.4).margin(kQuantum));
  CHECK(film.radiance(12, 21, 0) == 0.5);
  CHECK(film.radiance(12, 21, 1) == 1.0);
  CHECK(film.covered_samples(12, 21) == 1);
  CHECK(film.alpha(12, 21) == 1.0); // as this film does not know what shows through
  CHECK(film.samples(12, 21) == 2);
  for (int y = 20; y < 22; ++y) // and leaves the others alone
    for (int x = 10; x < 13; ++x)
      if (x != 12 || y != 21) {
        CHECK(film.color(x, y) == Xyz{0.0, 0.0, 0.0});
        CHECK(film.alpha(x, y) == 0.0);
        CHECK(film.radiance(x, y, 1) == 0.0);
        CHECK(film.samples(x, y) == 0);
      }
}

TEST_CASE("numbers that are no radiance are counted by kind and add nothing") {
  Film film = one_pixel();
  film.add({0, 0, 0, true}, {1.0, 2.0, 3.0}, {});
  film.add({0, 0, 1, true}, {kNan, 1.0, 1.0}, {});
  film.add({0, 0, 2, true}, {1.0, kInfinite, 1.0}, {});
  film.add({0, 0, 3, true}, {1.0, 1.0, -1e-9}, {});
  film.add({0, 0, 4, true}, {1.0, 1.0, 1e30}, {});
  CHECK(film.refused().not_finite == 2);
  CHECK(film.refused().negative == 1);
  CHECK(film.refused().overflow == 1);
  CHECK(film.samples(0, 0) == 5);
  CHECK(film.color(0, 0).x == Approx(1.0 / 5.0));
  CHECK(film.color(0, 0).z == Approx(3.0 / 5.0));
}

TEST_CASE("minus zero is no negative radiance") {
  Film film = one_pixel();
  film.add({0, 0, 0, true}, {-0.0, 0.0, 0.0}, {});
  CHECK(film.refused().negative == 0);
}

TEST_CASE("bands are refused one by one") {
  Film film = one_pixel(4);
  const std::vector<float> bands{kNan, -1.0f, 1e30f, 2.0f};
  film.add({0, 0, 0, true}, {1.0, 1.0, 1.0}, bands);
  CHECK(film.refused().not_finite == 1);
  CHECK(film.refused().negative == 1);
  CHECK(film.refused().overflow == 1);
  CHECK(film.radiance(0, 0, 0) == 0.0);
  CHECK(film.radiance(0, 0, 3) == 2.0);
  CHECK(film.color(0, 0).y == 1.0);
}

// The largest sum is 2^63 - 1 quanta.
TEST_CASE("a sum that is full stays as it is") {
  Film film({0, 0, 1, 1}, 1.0, 0);
  film.add({0, 0, 0, true}, {0x1p62, 0.0, 0.0}, {});
  film.add({0, 0, 1, true}, {0x1p62, 0.0, 0.0}, {});
  CHECK(film.refused().overflow == 1);
  CHECK(film.color(0, 0).x == 0x1p61);
}

// 16 bits would have counted 70000 as 4464.
TEST_CASE("the tally of refused samples does not wrap") {
  Film film = one_pixel();
  for (std::uint32_t i = 0; i < 70000; ++i)
    film.add({0, 0, i, true}, {kNan, 0.0, 0.0}, {});
  CHECK(film.refused().not_finite == 70000);
}

namespace {

Film film_of(const std::vector<double>& samples) {
  Film film({0, 0, 1, 1}, kQuantum, 0, true);
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    film.add({0, 0, i, true}, Xyz{1.0, 2.0, 4.0} * samples[i], {});
  return film;
}

} // namespace

// Parts of a and b samples with means A and B: sqrt(a b) / (a + b) |A - B|.
TEST_CASE("the error is the difference of the first samples and the rest") {
  const auto error = [](const std::vector<double>& samples) {
    return film_of(samples).error(0, 0);
  };
  CHECK(error({1, 3}).x == 1.0);
  CHECK(error({1, 3}).y == 2.0);
  CHECK(error({1, 3}).z == 4.0);
  CHECK(error({1, 3, 5}).x == Approx(std::sqrt(2.0) / 3.0 * 3.0));          // 2 | 5
  CHECK(error({1, 3, 5, 5}).x == Approx(0.5 * 3.0));                        // 2 | 5
  CHECK(error({1, 3, 5, 7, 8}).x == Approx(2.0 / 5.0 * 4.0));               // 4 | 8
  CHECK(error({1, 3, 5, 7, 8, 2}).x == Approx(std::sqrt(8.0) / 6.0 * 1.0)); // 4 | 5
  CHECK(error({0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1}).x == 0.0);
  CHECK(error({}).y == kInfinite);
  CHECK(error({1}).y == kInfinite);
  CHECK(film_of({1, 3, 5}).signed_error(0, 0).x == Approx(-std::sqrt(2.0)));
  CHECK(film_of({}).keeps_errors());
  CHECK_FALSE(one_pixel().keeps_errors());
}

// The error's square has the mean of the variance of the mean, here (1/12)/n. The square of one
// degree of freedom has a standard deviation of sqrt(2) of it: 2 % over 5000 pixels.
TEST_CASE("the error of independent samples is that of their mean") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  for (const int n : {2, 3, 5, 16, 24}) {
    INFO(n);
    double squares = 0.0;
    for (int pixel = 0; pixel < 5000; ++pixel) {
      std::vector<double> samples(static_cast<std::size_t>(n));
      for (double& s : samples)
        s = value(random);
      const double error = film_of(samples).error(0, 0).x;
      squares += error * error / 5000.0;
    }
    CHECK(squares * n == Approx(1.0 / 12.0).epsilon(0.08));
  }
}

TEST_CASE("alpha is what does not show through, as it is") {
  std::vector<LayerForm> layers = beauty_layers({.quantum = kQuantum});
  layers.push_back(transparency_layer());
  Film film({0, 0, 2, 1}, std::move(layers));
  CHECK(film.alpha(0, 0) == 0.0); // without samples
  const LayerId transparency = *film.find(kTransparency);
  film.add({0, 0, 0, true}, {0.0, 0.0, 0.0}, {});
  CHECK(film.alpha(0, 0) == 1.0);
  film.add(transparency, film.add({0, 0, 1, true}, {0.0, 0.0, 0.0}, {}), 0.5);
  CHECK(film.alpha(0, 0) == 0.75);
  film.add(transparency, film.add({1, 0, 0, true}, {0.0, 0.0, 0.0}, {}), 1.25); // stands for more
  CHECK(film.alpha(1, 0) == -0.25);
}
