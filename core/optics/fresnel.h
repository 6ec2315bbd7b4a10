#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace abbe {

using glm::dvec3;

/// The square of eta cos t, from Snell's law sin i = eta sin t, where `eta` is n_t / n_i: eta^2 -
/// sin^2 i, summed so that nothing cancels where media of nearly equal indices meet at a grazing
/// angle. It is positive where light is refracted, and not under total internal reflection. (The
/// thesis prints the test with 1 - N.dir, squared, in place of the squared cosine; that is a
/// misprint.)
[[nodiscard]] inline double refracted_part2(double cos_i, double eta) {
  return cos_i * cos_i + (eta - 1.0) * (eta + 1.0);
}

/// The cosine of the angle of refraction. Empty under total internal reflection.
[[nodiscard]] inline std::optional<double> refracted_cosine(double cos_i, double eta) {
  const double part2 = refracted_part2(cos_i, eta);
  if (!(part2 > 0.0)) return std::nullopt;
  return std::min(1.0, std::sqrt(part2) / eta);
}

/// Fresnel's reflectance of unpolarised light, the mean of its two polarisations [BW99, 1.5.2]:
/// r_s = (n_i cos i - n_t cos t) / (n_i cos i + n_t cos t), r_p = (n_t cos i - n_i cos t) / (...).
[[nodiscard]] inline double fresnel_reflectance(double cos_i, double cos_t, double eta) {
  const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  return 0.5 * (s * s + p * p);
}

/// The reflectance from the incident cosine alone; 1 under total internal reflection.
[[nodiscard]] inline double fresnel_reflectance(double cos_i, double eta) {
  const auto cos_t = refracted_cosine(cos_i, eta);
  return cos_t ? fresnel_reflectance(cos_i, *cos_t, eta) : 1.0;
}

/// The fractions of the light that a boundary reflects and transmits, before a surface scales them.
struct Fractions {
  double reflected, transmitted;
};

/// The fractions of a smooth boundary between two clear media. Without Fresnel's equations both are
/// 1, but nothing is transmitted under total internal reflection. The function is in line so that
/// loops over bands can be vectorised.
[[gnu::always_inline]] [[nodiscard]] inline Fractions
dielectric_fractions(bool fresnel, double cos_i, double n_before, double n_after) {
  const double eta = n_after / n_before;
  const double part2 = refracted_part2(cos_i, eta);
  const bool passes = part2 > 0.0;
  const double part = std::sqrt(std::max(part2, 0.0)); // eta cos t
  const double s = (cos_i - part) / (cos_i + part);
  const double across = eta * eta * cos_i;
  const double p = (across - part) / (across + part);
  const double reflectance = passes ? 0.5 * (s * s + p * p) : 1.0;
  return {fresnel ? reflectance : 1.0, fresnel ? 1.0 - reflectance : (passes ? 1.0 : 0.0)};
}

/// The direction of a mirror's ray. `normal` is unit and faces the incoming `direction`.
[[nodiscard]] inline dvec3 reflected(const dvec3& direction, const dvec3& normal) {
  return glm::normalize(direction - 2.0 * glm::dot(direction, normal) * normal);
}

/// The refracted direction, for given cosines before and behind the boundary.
[[nodiscard]] inline dvec3 refracted(const dvec3& direction, const dvec3& normal, double cos_i,
                                     double cos_t, double eta) {
  return glm::normalize(direction / eta + (cos_i / eta - cos_t) * normal);
}

} // namespace abbe
