#include "geometry/solids/circle_point.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>

using namespace abbe;

TEST_CASE("points of the circle are those of sine and cosine to the last places of a double") {
  const long double turn = 2.0L * std::numbers::pi_v<long double>;
  for (int i = -4000; i <= 8000; ++i) {
    const double turns = i / 4000.0 + (i % 7) * 1e-5;
    const dvec2 p = circle_point(turns);
    CAPTURE(turns);
    CHECK(std::abs(p.x - static_cast<double>(std::cos(turn * turns))) < 4e-16);
    CHECK(std::abs(p.y - static_cast<double>(std::sin(turn * turns))) < 4e-16);
  }
}

TEST_CASE("quarters of the circle are exact") {
  CHECK(circle_point(0.0) == dvec2(1.0, 0.0));
  CHECK(circle_point(0.25) == dvec2(0.0, 1.0));
  CHECK(circle_point(0.5) == dvec2(-1.0, 0.0));
  CHECK(circle_point(0.75) == dvec2(0.0, -1.0));
  CHECK(circle_point(1.0) == dvec2(1.0, 0.0));
}

TEST_CASE("small angles keep their relative precision") {
  for (double a = 0.785; a > 1e-300; a *= 0.3)
    CHECK(std::abs(small_angle_point(a).y / std::sin(a) - 1.0) < 4e-16);
}

TEST_CASE("the sine after some turns is that of the circle's point, without its sign") {
  const long double turn = 2.0L * std::numbers::pi_v<long double>;
  for (int i = -9000; i <= 9000; ++i) {
    const double turns = i / 3000.0 + (i % 11) * 1e-6;
    CAPTURE(turns);
    CHECK(std::abs(sine_of_turns(turns) - std::abs(static_cast<double>(std::sin(turn * turns)))) <
          1e-15);
  }
  for (double turns = 0.1; turns > 1e-300; turns *= 0.3) // the relative precision, too
    CHECK(sine_of_turns(-turns) ==
          Approx(static_cast<double>(std::sin(turn * turns))).epsilon(1e-15));
}
