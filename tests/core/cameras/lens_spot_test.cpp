#include "core/cameras/lens_spot.h"

#include "tests/catch.h"
#include "tests/core/cameras/lens_file.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

/// A thin biconvex lens of n = 1.5 and a small aperture: f = R / (2 (n - 1)) = 100 mm, nearly.
LensSystem small_lens() {
  LensPrescription lens;
  lens.surfaces.push_back({100.0, 0.001, ConstantIndex{1.5}, 0.05});
  lens.surfaces.push_back({-100.0, 0.0, ConstantIndex{1.0}, 0.1});
  return LensSystem(lens);
}

} // namespace

TEST_CASE("out of focus, a small lens draws a disc as wide as the cone of its light") {
  const LensSystem lens = small_lens();
  const double focus = lens.paraxial(550.0).back_focal_length();
  const auto sharp = lens_spot(lens, 550.0, 0.0, focus);
  REQUIRE(sharp);
  CHECK(sharp->rms_radius < 1e-7);
  CHECK(std::abs(sharp->middle) < 1e-12);
  // The root mean square radius of an even disc is its radius over sqrt(2).
  for (const double beyond : {5.0, -20.0}) {
    const auto spot = lens_spot(lens, 550.0, 0.0, focus + beyond);
    REQUIRE(spot);
    CHECK(spot->rms_radius ==
          Approx(0.05 * std::abs(beyond) / focus / std::numbers::sqrt2).epsilon(2e-3));
  }
}

TEST_CASE("light at an angle meets the film f tan(angle) off the axis") {
  const LensSystem lens = small_lens();
  const ParaxialLens paraxial = lens.paraxial(550.0);
  const auto spot = lens_spot(lens, 550.0, 2.0, paraxial.back_focal_length());
  REQUIRE(spot);
  const double expected = paraxial.focal_length() * std::tan(2.0 * std::numbers::pi / 180.0);
  CHECK(spot->middle == Approx(expected).epsilon(1e-4));
}

TEST_CASE("light that the lens stops has no spot") {
  // The stop lets fewer rays through than meet the first surface.
  const LensSystem triplet{test::lens_file("cooke_triplet")};
  CHECK_FALSE(lens_spot(triplet, 587.5618, 70.0, 40.0));
  const auto spot =
      lens_spot(triplet, 587.5618, 0.0, triplet.paraxial(587.5618).back_focal_length());
  REQUIRE(spot);
  const double part = std::pow(
      triplet.entrance_pupil_diameter() / 2.0 / triplet.surfaces().front().semi_diameter, 2.0);
  CHECK(spot->rays == Approx(part * 12892).epsilon(0.02));
}
