#include "core/optics/surface_optics.h"
#include "tests/catch.h"

#include <array>
#include <cmath>

using namespace abbe;

namespace {

constexpr std::array<double, 2> kAir{1.0, 1.0}, kGlass{1.5, 1.6}, kSameGlass{1.5, 1.5},
    kWavelengthsNm{500.0, 600.0};

SurfaceOptics boundary(const std::array<double, 2>& before, const std::array<double, 2>& after) {
  SurfaceOptics optics;
  optics.n_before = before.data();
  optics.n_after = after.data();
  return optics;
}

} // namespace

TEST_CASE("a metal reflects ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) of light that meets it upright") {
  const std::array<float, 2> n{0.25f, 1.5f}, k{3.0f, 0.5f};
  SurfaceOptics metal = boundary(kAir, kAir);
  metal.opaque = true;
  metal.metal_n = n.data();
  metal.metal_k = k.data();
  for (int b = 0; b < 2; ++b) {
    const double nb = n[static_cast<std::size_t>(b)], kb = k[static_cast<std::size_t>(b)];
    const double expected =
        ((nb - 1.0) * (nb - 1.0) + kb * kb) / ((nb + 1.0) * (nb + 1.0) + kb * kb);
    CHECK(metal.fractions(b, 1.0).reflected == Approx(expected).epsilon(1e-12));
    CHECK(metal.fractions(b, 1.0).transmitted == 0.0);
  }
  CHECK_FALSE(metal.alike(0, 2));
}

TEST_CASE("a mirror reflects all at every angle") {
  SurfaceOptics mirror = boundary(kAir, kAir);
  mirror.opaque = true;
  for (const double cosine : {1.0, 0.5, 1e-6})
    CHECK(mirror.fractions(0, cosine).reflected == 1.0);
  CHECK(mirror.alike(0, 2));
}

TEST_CASE("a film of the root of the glass's index, a quarter wavelength thick, reflects nothing") {
  const std::array<double, 2> film{std::sqrt(1.5), std::sqrt(1.5)};
  SurfaceOptics coated = boundary(kAir, kSameGlass);
  coated.film = {500.0 / (4.0 * film[0]), film.data(), kWavelengthsNm.data()};
  CHECK(coated.fractions(0, 1.0).reflected == Approx(0.0).margin(1e-14));
  CHECK(coated.fractions(0, 1.0).transmitted == Approx(1.0));
  CHECK(coated.fractions(1, 1.0).reflected > 1e-4); // made for 500 nm, it shows at 600 nm
}

TEST_CASE("bands are alike where both indices are equal and no film tells them apart") {
  CHECK(boundary(kAir, kSameGlass).alike(0, 2));
  CHECK_FALSE(boundary(kAir, kGlass).alike(0, 2));
  CHECK(boundary(kAir, kGlass).alike(1, 2));
  SurfaceOptics coated = boundary(kAir, kSameGlass);
  coated.film = {100.0, kSameGlass.data(), kWavelengthsNm.data()};
  CHECK_FALSE(coated.alike(0, 2));
}
