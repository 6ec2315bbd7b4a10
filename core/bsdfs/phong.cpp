#include "core/bsdfs/phong.h"

#include "geometry/solids/circle_point.h"

#include <glm/geometric.hpp>

#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

} // namespace

/// The pdf of Blinn's half vector is (e + 1) / (2 pi) cos^e about z. That of `wi` is this, divided
/// by four times the cosine between `wo` and the half vector.
double Phong::add(const Incidence& in, const dvec3& wi, float* f_cos) const {
  const dvec3 half = glm::normalize(in.wo + wi);
  const double bright = strength(half.z);
  const auto f = static_cast<float>(bright / kPi);
  const float* specular = reflectance.data();
  for (int b = in.bands.first; b < in.bands.last; ++b)
    f_cos[b] += specular[b] * f;
  const double cosine = glm::dot(in.wo, half);
  if (!(cosine > 0.0)) return 0.0;
  return (static_cast<double>(exponent) + 1.0) / (8.0 * kPi * cosine) * bright;
}

dvec3 Phong::sample(const Incidence& in, const dvec2& u) const {
  const double z = std::pow(u.x, 1.0 / (static_cast<double>(exponent) + 1.0));
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  const dvec3 half(r * circle_point(u.y), z);
  return 2.0 * glm::dot(in.wo, half) * half - in.wo;
}

} // namespace abbe
