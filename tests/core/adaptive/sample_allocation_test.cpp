#include "core/adaptive/sample_allocation.h"
#include "core/adaptive/sample_shares.h"
#include "tests/catch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

using namespace abbe;

namespace {

constexpr int kWidth = 60, kHeight = 40;
constexpr PixelWindow kWindow{7, 3, 7 + kWidth, 3 + kHeight};

/// So many black samples in each pixel.
Film film_of(std::uint32_t samples) {
  Film film(kWindow, 0x1p-40, 0, true);
  for_each_pixel(kWindow, [&](int x, int y) {
    for (std::uint32_t i = 0; i < samples; ++i)
      film.add({x, y, i, true}, {0.0, 0.0, 0.0}, {});
  });
  return film;
}

/// Shares for the left and the right half. They grow fourfold down the picture: numbers of samples
/// are rounded to powers of two, and over two octaves that averages out.
std::vector<float> halves(double left, double right) {
  std::vector<float> shares;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      shares.push_back(static_cast<float>((x < kWidth / 2 ? left : right) *
                                          std::exp2((y + x / 60.0) * 2.0 / kHeight)));
  return shares;
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

TEST_CASE("samples are in proportion to the shares, and meet the mean") {
  const Film film = film_of(2);
  for (const double mean : {20.0, 64.0, 100.0, 1000.0}) {
    const auto samples = allocate_samples(film, halves(0.5, 1.7), mean);
    CHECK(mean_of(samples, 0, kWidth) == Approx(mean).epsilon(0.02));
    CHECK(mean_of(samples, 30, kWidth) / mean_of(samples, 0, 30) == Approx(3.4).epsilon(0.1));
    for (const std::uint32_t n : samples)
      REQUIRE(std::has_single_bit(n));
  }
}

TEST_CASE("no pixel gets more than eight times the mean") {
  std::vector<float> shares(kWindow.pixel_count(), 0.35f);
  for (const int i : {0, 1, 2, 3})
    shares[static_cast<std::size_t>(20 * kWidth + 30 + i)] = 8.35f;
  const auto samples = allocate_samples(film_of(2), shares, 64.0);
  CHECK(samples[20 * kWidth + 30] == 512);
  CHECK(*std::max_element(samples.begin(), samples.end()) == 512);
}

TEST_CASE("no pixel gets fewer samples than it has") {
  Film film = film_of(2);
  for (std::uint32_t i = 2; i < 42; ++i)
    film.add({kWindow.x0, kWindow.y0, i, true}, {0.0, 0.0, 0.0}, {});
  const auto samples = allocate_samples(film, halves(0.35, 2.0), 8.0);
  CHECK(samples[0] == 42);
  CHECK(*std::min_element(samples.begin(), samples.end()) >= 2);
  CHECK(mean_of(samples, 0, kWidth) == Approx(8.0).epsilon(0.02));
}

TEST_CASE("shares of 0 ask for the mean itself") {
  const std::vector<float> shares(kWindow.pixel_count(), 0.0f);
  for (const std::uint32_t n : allocate_samples(film_of(4), shares, 23.0))
    REQUIRE(n == 23);
}
