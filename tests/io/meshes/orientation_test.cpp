#include "io/meshes/orientation.h"

#include "tests/catch.h"

#include <cmath>
#include <random>
#include <vector>

using namespace abbe;

namespace {

__extension__ typedef __int128 Wide; // products of differences of numbers below 2^53 fit

struct Place {
  std::int64_t x, y;

  [[nodiscard]] dvec2 point() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

int sign(Wide value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

int expected(const Place& a, const Place& b, const Place& c) {
  return sign(static_cast<Wide>(a.x - c.x) * (b.y - c.y) -
              static_cast<Wide>(a.y - c.y) * (b.x - c.x));
}

} // namespace

TEST_CASE("the sense of three points is exact where rounding would decide") {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::int64_t> step(-(1 << 20), 1 << 20), factor(1, 1 << 30),
      nudge(-1, 1);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const Place d{step(random), step(random)};
    const std::int64_t k = factor(random), m = factor(random);
    const Place a{nudge(random), nudge(random)}, b{k * d.x + nudge(random), k * d.y},
        c{m * d.x, m * d.y + nudge(random)};
    zeros += expected(a, b, c) == 0 ? 1 : 0;
    // A power of two changes no sign and no digit, also far from 1.
    for (const int exponent : {0, -480, 440}) {
      const double scale = std::ldexp(1.0, exponent);
      REQUIRE(orientation(scale * a.point(), scale * b.point(), scale * c.point()) ==
              expected(a, b, c));
    }
  }
  CHECK(zeros > 100);
}

TEST_CASE("the sense of three points looks at each digit") {
  // Of (0, 0), (1, 1) and (1 + e, 1) the third is to the right of the way, however small e is.
  const double e = std::ldexp(1.0, -52);
  CHECK(orientation({0, 0}, {1, 1}, {1 + e, 1}) == -1);
  CHECK(orientation({0, 0}, {1, 1}, {1, 1 + e}) == 1);
  CHECK(orientation({0, 0}, {1, 1}, {1 + e, 1 + e}) == 0);
  // 2^-450 beside 1: the difference is not even a double.
  const double tiny = std::ldexp(1.0, -450);
  CHECK(orientation({tiny, 0}, {1, 1}, {-1, -1}) == 1);
  CHECK(orientation({0, 0}, {1, 1}, {-1, -1}) == 0);
}

TEST_CASE("the sign of an area is exact") {
  // Out along a line and back to the other side of it by one unit in 2^52.
  const double far = std::ldexp(1.0, 52);
  const std::vector<dvec2> none{{0, 0}, {far, far}, {far / 2, far / 2}};
  const std::vector<dvec2> left{{0, 0}, {far, far}, {far / 2, far / 2 + 1}};
  const std::vector<dvec2> right{{0, 0}, {far, far}, {far / 2 + 1, far / 2}};
  CHECK(area_sign(none) == 0);
  CHECK(area_sign(left) == 1);
  CHECK(area_sign(right) == -1);
  CHECK(area_sign(std::vector<dvec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}) == 1);
  CHECK(area_sign(std::vector<dvec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}}) == -1);
  CHECK(area_sign(std::vector<dvec2>{{0, 0}, {1, 1}, {1, 0}, {0, 1}}) == 0); // an 8
}
