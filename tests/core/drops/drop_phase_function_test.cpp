#include "core/drops/drop_optics.h"
#include "core/drops/drop_phase_function.h"
#include "spectral/glass.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180.0;
constexpr double kSunRadius = 0.2665 * kDegree;

/// Seen at this angle from the antisolar point.
double value(const DropPhaseFunction& phase, double radius_deg, int band) {
  return static_cast<double>(phase.at(-std::cos(radius_deg * kDegree))[band]);
}

/// The radius between two others at which a band is brightest.
double brightest_deg(const DropPhaseFunction& phase, int band, double from_deg, double to_deg) {
  double best = from_deg;
  for (double radius = from_deg; radius <= to_deg; radius += 0.005)
    if (value(phase, radius, band) > value(phase, best, band)) best = radius;
  return best;
}

} // namespace

// The catalogue's other water was fitted to measurements in air.
TEST_CASE("water's index relative to air agrees with one that was measured in air") {
  const Dispersion& measured = find_glass("water-air-rel")->dispersion;
  for (double nm = 430.0; nm <= 660.0; nm += 10.0)
    CHECK(refractive_index(water_in_air(), nm) ==
          Approx(refractive_index(measured, nm)).margin(2e-5));
}

TEST_CASE("the phase function of every band is 1 over the sphere, but for the remainder") {
  for (const double radius : {0.0, kSunRadius}) {
    const DropPhaseFunction phase(ConstantIndex{1.3333}, {{500.0}, {600.0}}, radius, 1800);
    for (int band = 0; band < 2; ++band) {
      double sum = 0.0;
      for (std::size_t j = 0; j < 1800; ++j)
        sum += phase.flux(j, band);
      CHECK(sum ==
            Approx(1.0 - drop_remainder(1.3333, DropPhaseFunction::kLastOrder)).epsilon(1e-6));
    }
  }
}

TEST_CASE("a value is the cell's flux over its solid angle, and linear between cells") {
  const DropPhaseFunction phase(ConstantIndex{1.34}, {{550.0}}, 0.0, 180);
  const auto at_cell = [&](std::size_t j) {
    const double a = static_cast<double>(j) * kDegree;
    return phase.flux(j, 0) / (2.0 * kPi * (std::cos(a) - std::cos(a + kDegree)));
  };
  for (const std::size_t j :
       {std::size_t{0}, std::size_t{10}, std::size_t{137}, std::size_t{178}}) {
    const double center = (static_cast<double>(j) + 0.5) * kDegree;
    CHECK(phase.at(std::cos(center))[0] == Approx(at_cell(j)).epsilon(1e-5));
    CHECK(phase.at(std::cos(center + 0.25 * kDegree))[0] ==
          Approx(0.75 * at_cell(j) + 0.25 * at_cell(j + 1)).epsilon(1e-5));
  }
  CHECK(phase.at(1.0)[0] == Approx(at_cell(0)).epsilon(1e-5));
  CHECK(phase.at(-1.0 - 1e-12)[0] == Approx(at_cell(179)).epsilon(1e-5));
}

TEST_CASE("a band of several wavelengths has their mean") {
  const Dispersion water = water_in_air();
  const DropPhaseFunction one(water, {{400.0}, {700.0}}, 0.0, 360);
  const DropPhaseFunction both(water, {{400.0, 700.0}}, 0.0, 360);
  for (std::size_t j = 0; j < 360; ++j)
    CHECK(both.flux(j, 0) == Approx(0.5 * (one.flux(j, 0) + one.flux(j, 1))).margin(1e-7));
}

TEST_CASE("red is outside in the primary bow and inside in the secondary") {
  const DropPhaseFunction phase(water_in_air(), {{420.0}, {520.0}, {650.0}}, kSunRadius);
  const auto primary = [&](int band) { return brightest_deg(phase, band, 35.0, 45.0); };
  const auto secondary = [&](int band) { return brightest_deg(phase, band, 47.0, 57.0); };
  CHECK(primary(0) + 0.5 < primary(1));
  CHECK(primary(1) + 0.5 < primary(2));
  CHECK(secondary(2) + 0.9 < secondary(1));
  CHECK(secondary(1) + 0.9 < secondary(0));
  // Just outside of the violet bow only red is left, and just inside of the violet secondary.
  CHECK(value(phase, 42.2, 2) > 10.0 * value(phase, 42.2, 0));
  CHECK(value(phase, 50.7, 2) > 3.0 * value(phase, 50.7, 0));
  for (int band = 0; band < 3; ++band) // Alexander's band
    CHECK(value(phase, 46.0, band) < 0.1 * value(phase, primary(band), band));
}

TEST_CASE("the sun's disc takes the edge off a bow, by its radius and no more") {
  const DropPhaseFunction sharp(ConstantIndex{1.3311}, {{550.0}}, 0.0);
  const DropPhaseFunction soft(ConstantIndex{1.3311}, {{550.0}}, kSunRadius);
  const double bow = 42.355;
  CHECK(value(soft, bow + 0.2, 0) > 2.0 * value(sharp, bow + 0.2, 0));
  CHECK(value(soft, bow + 0.4, 0) == Approx(value(sharp, bow + 0.4, 0)).epsilon(1e-3));
  CHECK(value(soft, 38.0, 0) == Approx(value(sharp, 38.0, 0)).epsilon(1e-3));
  CHECK(value(soft, brightest_deg(soft, 0, 40.0, 44.0), 0) <
        0.6 * value(sharp, brightest_deg(sharp, 0, 40.0, 44.0), 0));
}
