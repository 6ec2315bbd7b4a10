#include "core/bsdfs/dielectric.h"
#include "tests/catch.h"

#include <array>
#include <cmath>

using namespace abbe;

namespace {

constexpr int kBands = 3;
using Indices = std::array<double, padded_band_count(kBands)>;
using Row = std::array<float, padded_band_count(kBands)>;

/// What stands behind the bands is of no meaning.
Indices indices(double a, double b, double c) {
  Indices found;
  found.fill(1.0);
  found[0] = a;
  found[1] = b;
  found[2] = c;
  return found;
}

/// A clear boundary that light meets in a medium of index 1, unless told otherwise, in three bands.
struct Boundary {
  Indices n_before = indices(1.0, 1.0, 1.0), n_after = indices(1.4, 1.5, 1.7);
  Row reflected{}, transmitted{};
  Dielectric surface;
  Incidence in;

  Boundary() {
    surface.reflectivity = surface.transparency = BandTable(1.0f, kBands);
    in.bands = {0, kBands};
    in.transport = Transport::flux;
  }
  void meet(double cosine) {
    in.n_before = n_before.data();
    in.n_after = n_after.data();
    in.wo = {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
    surface.specular(in, {reflected.data(), transmitted.data()});
  }
};

} // namespace

TEST_CASE("a clear boundary reflects ((n - 1) / (n + 1))^2 of light that meets it upright") {
  Boundary b;
  b.meet(1.0);
  for (std::size_t i = 0; i < kBands; ++i) {
    const double r = std::pow((b.n_after[i] - 1.0) / (b.n_after[i] + 1.0), 2);
    CHECK(b.reflected[i] == Approx(r).epsilon(1e-6));
    CHECK(b.transmitted[i] == Approx(1.0 - r).epsilon(1e-6));
  }
}

TEST_CASE("at Brewster's angle half of ((n^2 - 1) / (n^2 + 1))^2 is reflected") {
  // tan i = n: p-polarised light is not reflected, and s-polarised light by cos(i - r)^2 terms that
  // come to this.
  for (const double n : {1.3, 1.5, 2.4}) {
    Boundary b;
    b.n_after.fill(n);
    b.meet(1.0 / std::sqrt(1.0 + n * n));
    const double expected = 0.5 * std::pow((n * n - 1.0) / (n * n + 1.0), 2);
    for (std::size_t i = 0; i < kBands; ++i)
      CHECK(b.reflected[i] == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("beyond the critical angle all is reflected") {
  Boundary b;
  b.n_before.fill(1.5);
  b.n_after.fill(1.0);
  b.meet(std::sqrt(1.0 - 1.0 / (1.5 * 1.5)) * 0.999);
  for (std::size_t i = 0; i < kBands; ++i) {
    CHECK(b.reflected[i] == 1.0f);
    CHECK(b.transmitted[i] == 0.0f);
  }
}

TEST_CASE("radiance, but not flux, is scaled by the square of the indices' ratio") {
  Boundary flux, radiance;
  radiance.in.transport = Transport::radiance;
  flux.meet(0.7);
  radiance.meet(0.7);
  for (std::size_t i = 0; i < kBands; ++i) {
    CHECK(radiance.reflected[i] == flux.reflected[i]);
    CHECK(radiance.transmitted[i] ==
          Approx(flux.transmitted[i] / (flux.n_after[i] * flux.n_after[i])).epsilon(1e-6));
  }
}

TEST_CASE("a boundary between equal media is not there") {
  Boundary b;
  b.n_after = b.n_before;
  for (const double cosine : {1.0, 0.5, 1e-3}) {
    b.meet(cosine);
    for (std::size_t i = 0; i < kBands; ++i) {
      CHECK(b.reflected[i] < 1e-20f); // rounding alone: (2^-53 / cosine^2)^2
      CHECK(b.transmitted[i] == 1.0f);
    }
  }
}

TEST_CASE("a straight ray passes a boundary from either side alike") {
  Boundary in, out;
  std::swap(out.n_before, out.n_after);
  in.meet(0.6);
  out.meet(0.6);
  Row inwards{1, 1, 1}, outwards{1, 1, 1};
  in.surface.pass_straight(in.in, inwards.data());
  out.surface.pass_straight(out.in, outwards.data());
  for (std::size_t i = 0; i < kBands; ++i) {
    CHECK(inwards[i] == outwards[i]);
    CHECK(inwards[i] == in.transmitted[i]);
  }
}
