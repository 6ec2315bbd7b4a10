#pragma once

// Directions over the sphere for tests of scattering: sums on a grid, even points for sampling, and
// Pearson's test of samples against a density.

#include "core/optics/microfacet.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace abbe::test {

[[nodiscard]] inline dvec3 direction(double cos_theta, double phi) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cos_theta * cos_theta));
  return {sine * std::cos(phi), sine * std::sin(phi), cos_theta};
}

/// The integral of f over directions with cosines from `low` to `high`, by midpoints in theta and
/// phi.
template <class Function>
[[nodiscard]] double sphere_integral(Function f, double low = -1.0, double high = 1.0,
                                     int steps = 300, double phi_low = 0.0,
                                     double phi_high = 2.0 * std::numbers::pi) {
  const double theta0 = std::acos(high), theta1 = std::acos(low);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double theta = theta0 + (theta1 - theta0) * (i + 0.5) / steps;
    double ring = 0.0;
    for (int j = 0; j < steps; ++j)
      ring += f(direction(std::cos(theta), phi_low + (phi_high - phi_low) * (j + 0.5) / steps));
    sum += ring * std::sin(theta);
  }
  return sum * (theta1 - theta0) * (phi_high - phi_low) / (steps * static_cast<double>(steps));
}

/// The points of a lattice in the unit cube, by powers of the real root of g^4 = g + 1: they fill
/// it evenly.
[[nodiscard]] inline dvec3 lattice_point(int i) {
  const double g = 1.2207440846057596;
  const auto part = [&](double a) { return std::fmod(0.5 + (i + 1) / a, 1.0); };
  return {part(g), part(g * g), part(g * g * g)};
}

/// The mean of f_cos / density over directions that `sample(u, choice)` picks: the part of the
/// light that the surface gives back.
template <class Sample, class Weight>
[[nodiscard]] double sampled_albedo(int count, Sample sample, Weight weight) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const dvec3 u = lattice_point(i);
    if (const std::optional<dvec3> wi = sample(dvec2{u.x, u.y}, u.z)) sum += weight(*wi);
  }
  return sum / count;
}

/// Pearson's statistic of samples against a density over the sphere, as a normal deviate (by
/// Wilson and Hilferty's cube root): a fair sampler is above 4 once in 30000 times. The density
/// may leave a rest of samples that give no direction, which is a bin of its own.
template <class Sample, class Density>
[[nodiscard]] double deviation_from_density(Sample sample, Density density, int samples = 200000) {
  constexpr int kRings = 20, kSectors = 10;
  std::array<double, kRings * kSectors + 1> counted{}, expected{};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < samples; ++i) {
    const dvec2 u{uniform(random), uniform(random)};
    const std::optional<dvec3> wi = sample(u, uniform(random));
    std::size_t bin = kRings * kSectors;
    if (wi) {
      const double turn = std::atan2(wi->y, wi->x) / (2.0 * std::numbers::pi) + 0.5;
      const int ring = std::min(kRings - 1, static_cast<int>(0.5 * (wi->z + 1.0) * kRings));
      const int sector = std::min(kSectors - 1, static_cast<int>(turn * kSectors));
      bin = static_cast<std::size_t>(ring * kSectors + sector);
    }
    counted[bin] += 1.0;
  }
  double rest = 1.0;
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      const double width = 2.0 * std::numbers::pi / kSectors;
      const double p = sphere_integral(
          density, 2.0 * ring / kRings - 1.0, 2.0 * (ring + 1) / kRings - 1.0, 24,
          sector * width - std::numbers::pi, (sector + 1) * width - std::numbers::pi);
      expected[static_cast<std::size_t>(ring * kSectors + sector)] = p * samples;
      rest -= p;
    }
  expected.back() = std::max(0.0, rest) * samples;
  double chi2 = 0.0, few_counted = 0.0, few_expected = 0.0;
  int bins = 0;
  const auto add = [&](double c, double e) {
    chi2 += (c - e) * (c - e) / e;
    ++bins;
  };
  for (std::size_t i = 0; i < counted.size(); ++i)
    if (expected[i] >= 10.0)
      add(counted[i], expected[i]);
    else
      few_counted += counted[i], few_expected += expected[i];
  // At least one in the bin of rare directions: the integrals above are good to about that.
  add(few_counted, std::max(few_expected, 1.0));
  const double k = bins - 1.0;
  return (std::cbrt(chi2 / k) - (1.0 - 2.0 / (9.0 * k))) / std::sqrt(2.0 / (9.0 * k));
}

} // namespace abbe::test
