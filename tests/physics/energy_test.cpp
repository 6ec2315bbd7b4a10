#include "core/bsdfs/dielectric.h"
#include "tests/catch.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace abbe;

namespace {

constexpr int kBands = 5;
using Row = std::array<float, padded_band_count(kBands)>;
using Indices = std::array<double, padded_band_count(kBands)>;

struct Parts {
  Row reflected{}, transmitted{};
};

Incidence between(const Indices& before, const Indices& after, double cosine) {
  Incidence in;
  in.bands.last = kBands;
  in.n_before = before.data();
  in.n_after = after.data();
  in.wo = {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
  return in;
}

Parts specular(const Dielectric& surface, const Incidence& in) {
  Parts parts;
  surface.specular(in, {parts.reflected.data(), parts.transmitted.data()});
  return parts;
}

Dielectric boundary(float reflectivity, float transparency, bool fresnel = true) {
  return {BandTable(reflectivity, kBands), BandTable(transparency, kBands), fresnel, {}};
}

Indices all(double n) {
  Indices indices;
  indices.fill(n);
  return indices;
}

} // namespace

// Flux in = flux reflected + flux refracted. Radiance that passes is scaled by (n1/n2)^2, which
// is taken out again to compare fluxes.
TEST_CASE("a clear boundary loses no light at any angle, in any band") {
  const Indices air = all(1.0);
  Indices glass = all(1.0);
  const std::array<double, kBands> indices{1.3, 1.5, 1.7, 2.0, 2.4};
  std::ranges::copy(indices, glass.begin());
  for (const bool entering : {true, false})
    for (double cosine = 0.001; cosine <= 1.0; cosine += 0.001) {
      const Indices &before = entering ? air : glass, &after = entering ? glass : air;
      const Parts parts = specular(boundary(1.0f, 1.0f), between(before, after, cosine));
      for (std::size_t b = 0; b < kBands; ++b) {
        const double eta = after[b] / before[b];
        const double total = static_cast<double>(parts.reflected[b]) +
                             static_cast<double>(parts.transmitted[b]) * eta * eta;
        REQUIRE(total == Approx(1.0).margin(3e-7));
      }
    }
}

TEST_CASE("reflectivity and transparency scale Fresnel's two parts, or stand alone without it") {
  const Indices air = all(1.0), glass = all(1.5);
  Parts p = specular(boundary(0.5f, 0.25f), between(air, glass, 1.0)); // R0 = 0.04 for n = 1.5
  CHECK(p.reflected[0] == Approx(0.5 * 0.04));
  CHECK(p.transmitted[0] == Approx(0.25 * 0.96 / 2.25));
  p = specular(boundary(0.5f, 0.25f, false), between(air, glass, 1.0));
  CHECK(p.reflected[0] == Approx(0.5));
  CHECK(p.transmitted[0] == Approx(0.25 / 2.25));
  p = specular(boundary(0.5f, 0.25f, false), between(glass, air, 0.1)); // beyond the critical angle
  CHECK(p.transmitted[0] == 0.0f);
}

TEST_CASE("the straight shadow ray through a boundary is weakened by its transmittance") {
  const Indices air = all(1.0), glass = all(1.5);
  for (const bool entering : {true, false}) {
    Row passed;
    passed.fill(1.0f);
    boundary(1.0f, 1.0f)
        .pass_straight(between(entering ? air : glass, entering ? glass : air, 1.0), passed.data());
    CHECK(passed[0] == Approx(0.96));
  }
}
