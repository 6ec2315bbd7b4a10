#include "geometry/rays/transform.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

/// The largest sum of a row's magnitudes.
double row_norm(const glm::dmat3& m) {
  double norm = 0.0;
  for (int row = 0; row < 3; ++row)
    norm = std::max(norm, std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row]));
  return norm;
}

} // namespace

double Bounds::largest_coordinate() const {
  if (empty()) return 0.0;
  const dvec3 m = glm::max(glm::abs(lower), glm::abs(upper));
  return std::max({m.x, m.y, m.z});
}

Bounds Bounds::joined(const Bounds& other) const {
  return {glm::min(lower, other.lower), glm::max(upper, other.upper)};
}

Bounds Bounds::overlap(const Bounds& other) const {
  return {glm::max(lower, other.lower), glm::min(upper, other.upper)};
}

Bounds Bounds::grown(double margin) const {
  return {lower - dvec3(margin), upper + dvec3(margin)};
}

Transform::Transform(const glm::dmat3& linear, const dvec3& offset)
    : linear_(linear), offset_(offset) {
  const double determinant = glm::determinant(linear);
  if (!(std::abs(determinant) > 0.0) || !std::isfinite(determinant))
    throw std::invalid_argument("a transform that flattens space has no inverse");
  // Cofactors cancel where an axis is stretched much more than another. Extended precision leaves
  // one rounding per entry, up to stretches of about 2^11 to one.
  inverse_ = glm::dmat3(glm::inverse(glm::mat<3, 3, long double>(linear)));
  inverse_norm_ = row_norm(inverse_);
  image_size_ = largest_component(offset) + row_norm(linear);
}

Transform Transform::translation(const dvec3& offset) {
  return {glm::dmat3(1.0), offset};
}

Transform Transform::scaling(const dvec3& factors) {
  glm::dmat3 linear(0.0);
  for (int i = 0; i < 3; ++i)
    linear[i][i] = factors[i];
  return {linear, dvec3(0.0)};
}

Transform Transform::rotation(double angle_deg, const dvec3& axis) {
  const double length = glm::length(axis);
  if (!(length > 0.0)) throw std::invalid_argument("a rotation needs an axis of non-zero length");
  const dvec3 u = axis / length;
  // Quarter turns are exact, so that axis-aligned scenes stay axis-aligned.
  const double quarter_turns = angle_deg / 90.0;
  double c = std::cos(angle_deg * std::numbers::pi / 180.0);
  double s = std::sin(angle_deg * std::numbers::pi / 180.0);
  if (quarter_turns == std::round(quarter_turns)) {
    c = std::round(c);
    s = std::round(s);
  }
  // Rodrigues' formula: R v = c v + s u x v + (1 - c) u (u . v); columns are R e_i.
  glm::dmat3 linear(0.0);
  for (int i = 0; i < 3; ++i) {
    dvec3 e(0.0);
    e[i] = 1.0;
    linear[i] = c * e + s * glm::cross(u, e) + (1.0 - c) * u[i] * u;
  }
  return {linear, dvec3(0.0)};
}

Transform Transform::after(const Transform& inner) const {
  return {linear_ * inner.linear_, point(inner.offset_)};
}

Transform Transform::inverse() const {
  return {inverse_, -(inverse_ * offset_)};
}

dvec3 Transform::normal(const dvec3& n) const {
  return glm::normalize(n * inverse_);
}

Bounds Transform::box(const Bounds& bounds) const {
  const dvec3 center = point(0.5 * (bounds.lower + bounds.upper));
  const dvec3 half = 0.5 * (bounds.upper - bounds.lower);
  dvec3 reach(0.0);
  for (int i = 0; i < 3; ++i)
    reach += glm::abs(linear_[i]) * half[i];
  return {center - reach, center + reach};
}

Bounds Transform::unit_sphere_box() const {
  dvec3 reach;
  for (int row = 0; row < 3; ++row)
    reach[row] = std::hypot(linear_[0][row], linear_[1][row], linear_[2][row]);
  return {offset_ - reach, offset_ + reach};
}

Bounds Transform::disc_box(double z, double radius) const {
  const dvec3 center = point({0.0, 0.0, z});
  dvec3 reach;
  for (int row = 0; row < 3; ++row)
    reach[row] = radius * std::hypot(linear_[0][row], linear_[1][row]);
  return {center - reach, center + reach};
}

} // namespace abbe
