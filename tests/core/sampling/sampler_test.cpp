#include "core/sampling/sampler.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

using namespace abbe;

namespace {

std::vector<dvec2> points(int first, int count, std::uint32_t purpose, int x = 3, int y = 7,
                          std::uint64_t seed = 1) {
  std::vector<dvec2> result;
  for (int s = first; s < first + count; ++s)
    result.push_back(Sampler(x, y, static_cast<std::uint32_t>(s), seed).pair(purpose));
  return result;
}

/// True when the 2^k points are a (0,2)-net in base 2: every one of the 2^k equal boxes has one
/// point, however the square is cut into 2^i columns and 2^(k-i) rows.
bool is_net(const std::vector<dvec2>& points, int k) {
  for (int i = 0; i <= k; ++i) {
    std::set<std::pair<int, int>> boxes;
    for (const dvec2& p : points)
      boxes.insert(
          {static_cast<int>(std::ldexp(p.x, i)), static_cast<int>(std::ldexp(p.y, k - i))});
    if (boxes.size() != points.size()) return false;
  }
  return true;
}

/// The cumulative distributions whose inverses filter_offset computes.
double cumulative(PixelFilter filter, double x) {
  switch (filter) {
  case PixelFilter::box:
    return x + 0.5;
  case PixelFilter::tent: // the pdf is 1 - |x|
    return x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
  case PixelFilter::gaussian: { // sigma 0.5, cut off at 3 sigma
    const double most = std::erf(3.0 / std::numbers::sqrt2);
    return 0.5 + 0.5 * std::erf(x / 0.5 / std::numbers::sqrt2) / most;
  }
  }
  return 0.0;
}

} // namespace

TEST_CASE("any power of two of samples is stratified in each purpose") {
  for (const std::uint32_t purpose : {kPixelPosition, kWavelength})
    for (int k = 0; k <= 10; ++k) {
      CAPTURE(purpose, k);
      CHECK(is_net(points(0, 1 << k, purpose), k));
      CHECK(is_net(points(5 << k, 1 << k, purpose), k)); // and so is each later block
    }
}

TEST_CASE("a sample's numbers depend on pixel, index, seed and purpose, and on nothing else") {
  const dvec2 p = Sampler(3, 7, 5, 1).pair(kPixelPosition);
  CHECK(Sampler(3, 7, 5, 1).pair(kPixelPosition) == p);
  CHECK(Sampler(3, 7, 5, 1).pair(kWavelength) != p);
  CHECK(Sampler(7, 3, 5, 1).pair(kPixelPosition) != p);
  CHECK(Sampler(3, 8, 5, 1).pair(kPixelPosition) != p);
  CHECK(Sampler(3, 7, 6, 1).pair(kPixelPosition) != p);
  CHECK(Sampler(3, 7, 5, 2).pair(kPixelPosition) != p);
  CHECK(Sampler(3, 7, 5, 1ull << 63).pair(kPixelPosition) != p);
}

// For independent uniform numbers the mean of (u - 1/2) (v - 1/2) over N has the standard deviation
// 1 / (12 sqrt(N)), which is 0.0026 for 1024 pixels. The limit is five of them.
TEST_CASE("purposes, neighbours and seeds are uncorrelated") {
  double purposes = 0.0, neighbours = 0.0, seeds = 0.0, axes = 0.0;
  constexpr int kSide = 32;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const dvec2 u = Sampler(x, y, 0, 1).pair(kPixelPosition) - 0.5;
      purposes += u.x * (Sampler(x, y, 0, 1).pair(kWavelength).x - 0.5);
      neighbours += u.x * (Sampler(x + 1, y, 0, 1).pair(kPixelPosition).x - 0.5);
      seeds += u.x * (Sampler(x, y, 0, 2).pair(kPixelPosition).x - 0.5);
      axes += u.x * u.y;
    }
  for (const double sum : {purposes, neighbours, seeds, axes})
    CHECK(std::abs(sum / (kSide * kSide)) < 5.0 / (12.0 * kSide));
}

// The mean of N uniform numbers has the standard deviation 1 / sqrt(12 N), the mean of the products
// of neighbours about their mean 1 / (12 sqrt(N)).
TEST_CASE("a path's decisions are a stream of its own, uniform and without memory") {
  DecisionStream stream = Sampler(3, 7, 5, 1).decisions();
  DecisionStream again = Sampler(3, 7, 5, 1).decisions();
  DecisionStream other_index = Sampler(3, 7, 6, 1).decisions();
  DecisionStream other_pixel = Sampler(4, 7, 5, 1).decisions();
  constexpr int kCount = 10000;
  double mean = 0.0, neighbours = 0.0, indices = 0.0, last = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double u = stream.next();
    REQUIRE(u == again.next());
    REQUIRE(u >= 0.0);
    REQUIRE(u < 1.0);
    const double next_index = other_index.next();
    CHECK(u != next_index);
    CHECK(u != other_pixel.next());
    mean += u / kCount;
    neighbours += (u - 0.5) * last / kCount;
    indices += (u - 0.5) * (next_index - 0.5) / kCount;
    last = u - 0.5;
  }
  CHECK(std::abs(mean - 0.5) < 5.0 / std::sqrt(12.0 * kCount));
  CHECK(std::abs(neighbours) < 5.0 / (12.0 * std::sqrt(kCount)));
  CHECK(std::abs(indices) < 5.0 / (12.0 * std::sqrt(kCount)));
}

TEST_CASE("filter offsets invert the filter's cumulative distribution") {
  for (const PixelFilter filter : {PixelFilter::box, PixelFilter::tent, PixelFilter::gaussian})
    for (double u = 0.0; u < 1.0; u += 1.0 / 4096.0) {
      const dvec2 at = filter_offset(filter, {u, 1.0 - 0x1p-32 - u});
      // The normal distribution's inverse is a table of 1024 steps, coarse where the pdf is low.
      REQUIRE(cumulative(filter, at.x) == Approx(u).margin(1e-4));
      REQUIRE(cumulative(filter, at.y) == Approx(1.0 - u).margin(1e-4));
      REQUIRE(std::abs(at.x) <= filter_radius(filter));
      REQUIRE(std::abs(at.y) <= filter_radius(filter));
    }
}

// The variance of the box is 1/12, that of the tent 1/6, and that of the normal distribution which
// is truncated at a = 3 sigma is sigma^2 (1 - 2 a phi(a) / (2 Phi(a) - 1)).
TEST_CASE("samples through a filter have its variance") {
  const double tail = 2.0 * 3.0 * std::exp(-4.5) / std::sqrt(2.0 * std::numbers::pi) /
                      std::erf(3.0 / std::numbers::sqrt2);
  const auto variance = [](PixelFilter filter) {
    double sum = 0.0;
    const auto u = points(0, 4096, kPixelPosition);
    for (const dvec2& p : u) {
      const dvec2 offset = filter_offset(filter, p);
      sum += 0.5 * (offset.x * offset.x + offset.y * offset.y);
    }
    return sum / static_cast<double>(u.size());
  };
  CHECK(variance(PixelFilter::box) == Approx(1.0 / 12.0).epsilon(1e-3));
  CHECK(variance(PixelFilter::tent) == Approx(1.0 / 6.0).epsilon(1e-3));
  CHECK(variance(PixelFilter::gaussian) == Approx(0.25 * (1.0 - tail)).epsilon(1e-3));
}
