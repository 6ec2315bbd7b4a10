#include "spectral/smooth_emissions.h"

#include "spectral/band_grid.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace abbe;

namespace {

/// The colour of D65 times a curve, relative to D65.
LinearRgb seen(const SmoothCurve& curve) {
  static const Curve d65 = *find_illuminant("D65");
  static const LinearRgb white = to_linear_srgb(to_xyz(d65));
  std::vector<double> values;
  for (int k = 0; k < kSampleCount; ++k)
    values.push_back(curve.at(sample_nm(k)));
  const LinearRgb rgb = to_linear_srgb(to_xyz(d65.times(Curve::samples81(values))));
  return {rgb.r / white.r, rgb.g / white.g, rgb.b / white.b};
}

double distance(const LinearRgb& a, const LinearRgb& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

double largest(const LinearRgb& c) {
  return std::max({c.r, c.g, c.b});
}

} // namespace

TEST_CASE("a smooth curve makes D65 an emission of its colour") {
  for (const LinearRgb& c : {LinearRgb{0.3, 0.5, 0.1}, LinearRgb{40.0, 2.0, 9.0},
                             LinearRgb{1e-4, 3e-4, 2e-4}, LinearRgb{0.0, 1.0, 0.5}})
    CHECK(distance(seen(smooth_emission(c)), c) < 1e-6 * largest(c));
}

TEST_CASE("a table of smooth curves has nearly the colours asked for, and greys exactly") {
  const SmoothEmissions table;
  std::mt19937 engine(3);
  const auto number = [&] { return std::ldexp(static_cast<double>(engine()), -32); };
  double worst = 0.0, sum = 0.0;
  constexpr int kColors = 3000;
  for (int i = 0; i < kColors; ++i) {
    const double x = number(), y = number();
    const LinearRgb c{x, y, number()};
    const double error = distance(seen(table.of(c)), c) / largest(c);
    worst = std::max(worst, error);
    sum += error;
  }
  CHECK(worst < 1.5e-3);
  CHECK(sum / kColors < 1e-4);
  for (const LinearRgb& c : {LinearRgb{1, 0, 0}, LinearRgb{0, 2, 0}, LinearRgb{0, 0, 3},
                             LinearRgb{1, 1, 0}, LinearRgb{0, 5, 5}, LinearRgb{1, 0, 1}})
    CHECK(distance(seen(table.of(c)), c) < 1.5e-3 * largest(c));
  for (const double grey : {1e-3, 0.18, 1.0, 5e4}) {
    const SmoothCurve curve = table.of({grey, grey, grey});
    CHECK(curve.at(400.0) == Approx(grey).epsilon(1e-12));
    CHECK(curve.at(700.0) == Approx(grey).epsilon(1e-12));
  }
  CHECK(table.of({0, 0, 0}).at(500.0) == 0.0);
  CHECK(table.of({-1, -2, -3}).at(500.0) == 0.0);
}
