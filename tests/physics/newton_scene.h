#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <utility>

namespace abbe::test {

// Newton's experiment: a narrow beam through a prism of SF11 falls on a wall. Where each band lands
// and how much of it arrives is known from Snell's and Fresnel's laws for the beam's axis.

inline constexpr double kNewtonWall = 5.5;
inline const glm::dvec2 kNewtonLamp{-4.6654423, -1.8996736};
inline const glm::dvec2 kNewtonAxis = glm::normalize(glm::dvec2(4.1654423, 2.765699));

inline const char* const kNewtonScene =
    "integrator path\n"
    "falloff square\n"
    "spotlight E -4.6654423 -1.8996736 0 1  4.1654423 2.765699 0  0.02\n"
    "glass SF11\n"
    "polyhedron vertices 6  -1 0 1  1 0 1  0 1.7320508 1\n"
    "                       -1 0 -1  0 1.7320508 -1  1 0 -1\n"
    "defaultMaterials diffuse 0.78 0.78 0.78\n"
    "translate 5.5 -2 0 rotate -90 0 1 0 scale 9 9 1 square\n";

struct NewtonArrival {
  double y;             ///< on the wall
  double transmittance; ///< of the two faces
};

/// The axis of the beam, in the plane of the prism's section.
inline NewtonArrival newton_arrival(double n) {
  using glm::dvec2;
  const auto face = [](const dvec2& a, const dvec2& b) {
    const dvec2 along = glm::normalize(b - a);
    return std::pair(a, dvec2(along.y, -along.x)); // a point, and a normal
  };
  const dvec2 left(-1.0, 0.0), right(1.0, 0.0), top(0.0, 1.7320508);
  dvec2 p = kNewtonLamp, d = kNewtonAxis;
  double passed = 1.0;
  const auto cross = [&](const dvec2& a, const dvec2& b, double eta) {
    auto [point, normal] = face(a, b);
    if (glm::dot(normal, d) > 0.0) normal = -normal;
    p += d * (glm::dot(point - p, normal) / glm::dot(d, normal));
    const double cos_i = -glm::dot(d, normal);
    const double cos_t = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (eta * eta));
    const double rs = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double rp = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    passed *= 1.0 - 0.5 * (rs * rs + rp * rp);
    d = d / eta + (cos_i / eta - cos_t) * normal;
  };
  cross(left, top, n);
  cross(top, right, 1.0 / n);
  return {p.y + d.y * (kNewtonWall - p.x) / d.x, passed};
}

/// The beam's flux per unit of its spectrum: its solid angle.
inline constexpr double kNewtonBeam =
    3.14159265358979 * (0.02 * 3.14159265358979 / 180.0) * (0.02 * 3.14159265358979 / 180.0);

} // namespace abbe::test
