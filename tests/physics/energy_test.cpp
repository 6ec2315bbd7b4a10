#include "core/scattering/dielectric.h"
#include "tests/catch.h"

#include <cmath>
#include <vector>

using namespace abbe;

namespace {

MaterialPlan clear_glass(int bands) {
  MaterialPlan glass;
  glass.reflectivity = BandTable(1.0f, bands);
  glass.transparency = BandTable(1.0f, bands);
  return glass;
}

} // namespace

// Flux in = flux reflected + flux refracted. Radiance that passes is scaled by (n1/n2)^2, which
// is taken out again to compare fluxes.
TEST_CASE("a clear boundary loses no light at any angle, in any band") {
  constexpr int kBands = 5;
  const std::vector<double> air(kBands, 1.0), glass{1.3, 1.5, 1.7, 2.0, 2.4};
  DielectricScatter scatter{std::vector<float>(kBands), std::vector<float>(kBands)};
  for (const bool entering : {true, false})
    for (double cosine = 0.001; cosine <= 1.0; cosine += 0.001) {
      const double* before = entering ? air.data() : glass.data();
      const double* after = entering ? glass.data() : air.data();
      scatter_dielectric(clear_glass(kBands), cosine, before, after, 0, kBands, scatter);
      for (std::size_t b = 0; b < kBands; ++b) {
        const double eta = after[b] / before[b];
        const double total = static_cast<double>(scatter.reflected[b]) +
                             static_cast<double>(scatter.transmitted[b]) * eta * eta;
        REQUIRE(total == Approx(1.0).margin(3e-7));
      }
    }
}

TEST_CASE("reflectivity and transparency scale Fresnel's two parts, or stand alone without it") {
  constexpr int kBands = 1;
  const double air = 1.0, glass = 1.5;
  DielectricScatter s{std::vector<float>(kBands), std::vector<float>(kBands)};
  MaterialPlan m;
  m.reflectivity = BandTable(0.5f, kBands);
  m.transparency = BandTable(0.25f, kBands);
  scatter_dielectric(m, 1.0, &air, &glass, 0, kBands, s); // R0 = 0.04 for n = 1.5
  CHECK(s.reflected[0] == Approx(0.5 * 0.04));
  CHECK(s.transmitted[0] == Approx(0.25 * 0.96 / 2.25));
  m.fresnel = false;
  scatter_dielectric(m, 1.0, &air, &glass, 0, kBands, s);
  CHECK(s.reflected[0] == Approx(0.5));
  CHECK(s.transmitted[0] == Approx(0.25 / 2.25));
  scatter_dielectric(m, 0.1, &glass, &air, 0, kBands, s); // beyond the critical angle
  CHECK(s.transmitted[0] == 0.0f);
}

TEST_CASE("the straight shadow ray through a boundary is weakened by its transmittance") {
  const double air = 1.0, glass = 1.5;
  const MaterialPlan m = clear_glass(1);
  for (const bool entering : {true, false}) {
    float passed = 1.0f;
    attenuate_straight(m, 1.0, entering ? &air : &glass, entering ? &glass : &air, 0, 1, &passed);
    CHECK(passed == Approx(0.96));
  }
}
