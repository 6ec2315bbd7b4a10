#include "core/bsdfs/bsdf.h"
#include "tests/catch.h"
#include "tests/core/bsdfs/pane_series.h"

#include <array>
#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

constexpr int kBands = 3;
constexpr double kDegree = std::numbers::pi / 180.0;

struct Row {
  std::array<float, kBands> values{};
  [[nodiscard]] double at(std::size_t b) const { return static_cast<double>(values[b]); }
};

/// A pane at an angle, whose glass has a different index in each band.
struct Pane {
  std::array<double, kBands> before, glass;
  ThinGlass surface;
  Incidence in;
  Row reflected, transmitted, straight{{1.0f, 0.5f, 0.25f}};

  Pane(double angle, double n_before, const std::array<double, kBands>& n_glass,
       const BandTable& absorption, float reflectivity = 1.0f, float transparency = 1.0f)
      : glass(n_glass),
        surface{0, absorption, BandTable(reflectivity, kBands), BandTable(transparency, kBands)} {
    before.fill(n_before);
    in.bands.last = kBands;
    in.n_before = in.n_after = before.data();
    in.n_layer = glass.data();
    in.wo = {std::sin(angle), 0.0, std::cos(angle)};
    const Bsdf bsdf = surface;
    specular_factors(bsdf, in, {reflected.values.data(), transmitted.values.data()});
    pass_straight(bsdf, in, straight.values.data());
  }
};

const BandTable kClear(0.0f, kBands);

} // namespace

TEST_CASE("a pane reflects and transmits the sum over the reflections between its faces") {
  const BandTable grey(std::vector<double>{0.0, 0.2, 3.0});
  const std::array<double, kBands> indices{1.5, 1.5, 1.9};
  for (const double n_before : {1.0, 1.33})
    for (const double degrees : {0.0, 10.0, 30.0, 45.0, 56.309932, 70.0, 80.0, 88.0}) {
      const Pane pane(degrees * kDegree, n_before, indices, grey);
      for (std::size_t b = 0; b < kBands; ++b) {
        CAPTURE(n_before, degrees, b);
        const auto expected = test::pane_series(degrees * kDegree, n_before, indices[b],
                                                static_cast<double>(grey[static_cast<int>(b)]));
        CHECK(pane.reflected.at(b) == Approx(expected.reflected).epsilon(1e-5));
        CHECK(pane.transmitted.at(b) == Approx(expected.transmitted).epsilon(1e-5));
      }
    }
}

TEST_CASE("a clear pane loses no light") {
  for (double degrees = 0.0; degrees < 90.0; degrees += 0.5) {
    const Pane pane(degrees * kDegree, 1.0, {1.2, 1.5, 2.4}, kClear);
    for (std::size_t b = 0; b < kBands; ++b)
      CHECK(pane.reflected.at(b) + pane.transmitted.at(b) == Approx(1.0).epsilon(3e-7));
  }
}

TEST_CASE("at normal incidence a pane reflects 2 r / (1 + r), with r = 0.04 at an index of 1.5") {
  const Pane pane(0.0, 1.0, {1.5, 1.5, 1.5}, kClear);
  CHECK(pane.reflected.at(0) == Approx(0.08 / 1.04));
  CHECK(pane.transmitted.at(0) == Approx(0.96 / 1.04));
}

TEST_CASE("a pane of the index around it changes nothing; grazing light is all reflected") {
  const Pane none(1.0, 1.33, {1.33, 1.33, 1.33}, kClear);
  CHECK(none.reflected.at(1) == Approx(0.0).margin(1e-12));
  CHECK(none.transmitted.at(1) == 1.0);
  Pane along(0.0, 1.0, {1.5, 1.5, 1.5}, kClear);
  along.in.wo = {1.0, 0.0, 0.0};
  along.surface.specular(along.in,
                         {along.reflected.values.data(), along.transmitted.values.data()});
  CHECK(along.reflected.at(0) == 1.0);
  CHECK(along.transmitted.at(0) == 0.0);
}

TEST_CASE("a pane of a lower index than around it reflects totally beyond the critical angle") {
  const Pane beyond(60.0 * kDegree, 1.5, {1.0, 1.2, 1.5}, kClear); // limits: 41.8, 53.1 degrees
  CHECK(beyond.reflected.at(0) == 1.0);
  CHECK(beyond.transmitted.at(1) == 0.0);
  CHECK(beyond.transmitted.at(2) == 1.0);
}

TEST_CASE("reflectivity and transparency scale what a pane reflects and transmits") {
  const Pane pane(0.5, 1.0, {1.5, 1.5, 1.5}, kClear, 0.5f, 0.25f);
  const auto whole = test::pane_series(0.5, 1.0, 1.5, 0.0);
  CHECK(pane.reflected.at(2) == Approx(0.5 * whole.reflected));
  CHECK(pane.transmitted.at(2) == Approx(0.25 * whole.transmitted));
}

TEST_CASE("a straight ray through a pane is weakened by its transmittance") {
  const Pane pane(0.9, 1.0, {1.4, 1.5, 1.6}, kClear);
  const std::array<double, kBands> had{1.0, 0.5, 0.25};
  for (std::size_t b = 0; b < kBands; ++b)
    CHECK(pane.straight.at(b) == Approx(had[b] * pane.transmitted.at(b)).epsilon(1e-6));
}

TEST_CASE("a pane reflects along one ray and lets the rest pass without a bounce") {
  const BsdfFacts facts = facts_of(ThinGlass{0, kClear, BandTable(1.0f, 3), BandTable(1.0f, 3)});
  CHECK((facts.reflects && facts.passes && !facts.transmits && !facts.rough && !facts.coats));
  CHECK(facts.specular());
}
