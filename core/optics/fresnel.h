#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace abbe {

using glm::dvec3;

/// The cosine of the angle of refraction, from Snell's law n_i sin i = n_t sin t. `eta` is n_t /
/// n_i. Empty under total internal reflection, (sin i / eta)^2 > 1. (The thesis prints the test
/// with 1 - N.dir, squared, in place of the squared cosine; that is a misprint.)
[[nodiscard]] inline std::optional<double> refracted_cosine(double cos_i, double eta) {
  const double sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1.0) return std::nullopt;
  return std::sqrt(1.0 - sin2_t);
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
  const double eta = n_after / n_before, inverse = n_before / n_after;
  const double cos2_t = 1.0 - (1.0 - cos_i * cos_i) * (inverse * inverse);
  const bool passes = cos2_t > 0.0;
  const double cos_t = std::sqrt(std::max(cos2_t, 0.0));
  const double reflectance = passes ? fresnel_reflectance(cos_i, cos_t, eta) : 1.0;
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
