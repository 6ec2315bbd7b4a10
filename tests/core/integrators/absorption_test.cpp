#include "core/integrators/absorption.h"
#include "tests/catch.h"

#include <cmath>
#include <limits>

using namespace abbe;

namespace {

/// Absorption 0, 0.5 and 2 per unit in three bands.
MediumPlan dye() {
  MediumPlan medium;
  medium.absorption_per_unit = BandTable(std::vector<double>{0.0, 0.5, 2.0});
  medium.absorbs = true;
  return medium;
}

} // namespace

TEST_CASE("throughput falls by exp(-absorption * length) in the asked bands") {
  float throughput[3] = {0.5f, 0.5f, 0.5f};
  absorb(dye(), 3.0, {throughput, {0, 2}});
  CHECK(throughput[0] == 0.5f);
  CHECK(throughput[1] == Approx(0.5 * std::exp(-1.5)).epsilon(1e-6));
  CHECK(throughput[2] == 0.5f);
}

TEST_CASE("an infinite length leaves the bands that are not absorbed, and nothing else") {
  float throughput[3] = {1.0f, 1.0f, 1.0f};
  absorb(dye(), std::numeric_limits<double>::infinity(), {throughput, {0, 3}});
  CHECK(throughput[0] == 1.0f);
  CHECK(throughput[1] == 0.0f);
  CHECK(throughput[2] == 0.0f);
}

TEST_CASE("a clear medium takes nothing, at any length") {
  float throughput[1] = {0.7f};
  absorb(MediumPlan{}, std::numeric_limits<double>::infinity(), {throughput, {0, 1}});
  CHECK(throughput[0] == 0.7f);
}

TEST_CASE("a medium alike in all bands absorbs as one that is tabulated") {
  MediumPlan grey = dye();
  grey.absorption_per_unit = BandTable(0.5f, 3);
  float throughput[3] = {0.5f, 0.5f, 0.5f};
  absorb(grey, 3.0, {throughput, {1, 3}});
  CHECK(throughput[0] == 0.5f);
  CHECK(throughput[1] == Approx(0.5 * std::exp(-1.5)).epsilon(1e-6));
  CHECK(throughput[2] == throughput[1]);
}
