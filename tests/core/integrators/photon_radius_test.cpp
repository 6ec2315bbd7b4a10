#include "core/integrators/photon_radius.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace abbe;

namespace {

/// Photons anywhere in a square of side^2, one per unit of area, on a tilted plane.
std::vector<PhotonBatch> square(int side) {
  std::mt19937 bits(7);
  std::uniform_real_distribution<double> place(0.0, side);
  std::vector<PhotonBatch> batches(2);
  const float flux = 1.0f;
  for (int i = 0; i < side * side; ++i) {
    Photon photon;
    const double y = place(bits);
    photon.position = {place(bits), 0.6 * y, 0.8 * y};
    batches[static_cast<std::size_t>(i % 2)].add(photon, {&flux, {0, 1}}, 1.0);
  }
  return batches;
}

} // namespace

TEST_CASE("the first radius holds five dozen photons, of many or few") {
  // A disc with as large an area, and photons near the border that see only part of it.
  const double expected = std::sqrt(kPhotonsWithin / std::numbers::pi);
  for (const int side : {60, 160, 500})
    CHECK(first_photon_radius(square(side), 1e6) == Approx(expected).epsilon(0.15));
}

TEST_CASE("the first radius where photons tell nothing, or too much") {
  CHECK(first_photon_radius({}, 3.0) == 3.0);
  CHECK(first_photon_radius(square(1), 3.0) == 3.0);
  CHECK(first_photon_radius(square(40), 0.5) == 0.5);
  // The others of so few lie within it.
  CHECK(first_photon_radius(square(2), 1e6) < 3.0);
  std::vector<PhotonBatch> same(1);
  const float flux = 1.0f;
  for (int i = 0; i < 100; ++i) {
    same[0].add(Photon(), {&flux, {0, 1}}, 1.0);
  }
  CHECK(first_photon_radius(same, 3.0) == 3.0);
}

TEST_CASE("the squared radius falls as the passes to the power of -1/2") {
  CHECK(photon_radius(2.0, 0) == 2.0);
  const double ratio = photon_radius(1.0, 8000) / photon_radius(1.0, 1000);
  CHECK(ratio * ratio == Approx(std::pow(8.0, -0.5)).epsilon(1e-3));
}
