#include "core/lights/light_reach.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

using std::numbers::pi;

/// Cosines round, and near 1 an angle has half of their digits. What arrives beyond a cone's border
/// by less than this many radians is not counted as nothing.
constexpr double kAngleError = 0x1p-24;

/// Of a squared distance, so that a place at a point of light has a finite value.
constexpr double kLeastSquare = 1e-200;

/// A cone of directions by its axis and half-angle.
struct Directions {
  dvec3 axis;
  double half_angle;
};

/// The narrowest cone that holds two, or all directions.
Directions joined(const Directions& a, const Directions& b) {
  const Directions& wide = a.half_angle >= b.half_angle ? a : b;
  const Directions& narrow = a.half_angle >= b.half_angle ? b : a;
  const double between = std::acos(std::clamp(glm::dot(wide.axis, narrow.axis), -1.0, 1.0));
  if (between + narrow.half_angle <= wide.half_angle) return wide;
  const double half = 0.5 * (wide.half_angle + between + narrow.half_angle) + kAngleError;
  const dvec3 across = narrow.axis - glm::dot(wide.axis, narrow.axis) * wide.axis;
  const double length = glm::length(across);
  if (half >= pi || !(length > 0.0)) return {wide.axis, pi};
  const double turn = half - wide.half_angle;
  return {glm::normalize(std::cos(turn) * wide.axis + std::sin(turn) / length * across), half};
}

/// An angle from 0 to pi by its cosine and sine.
struct Angle {
  double cosine, sine;

  /// The angle less another, or 0.
  [[nodiscard]] Angle less(const Angle& other) const {
    if (cosine >= other.cosine) return {1.0, 0.0};
    return {cosine * other.cosine + sine * other.sine, sine * other.cosine - cosine * other.sine};
  }
};

} // namespace

LightReach LightReach::along(const dvec3& axis, double normals, double spread) const {
  LightReach narrowed = *this;
  narrowed.axis_ = axis;
  const bool all = normals >= pi;
  narrowed.cos_normals_ = all ? -1.0 : std::cos(normals);
  narrowed.sin_normals_ = all ? 0.0 : std::sin(normals);
  narrowed.cos_spread_ = std::cos(spread);
  narrowed.sin_spread_ = std::sin(spread);
  return narrowed;
}

double LightReach::normals() const {
  return std::atan2(sin_normals_, cos_normals_);
}

double LightReach::spread() const {
  return std::atan2(sin_spread_, cos_spread_);
}

LightReach LightReach::times(double factor) const {
  LightReach brighter = *this;
  brighter.falling_ *= factor;
  brighter.steady_ *= factor;
  return brighter;
}

double LightReach::at(const dvec3& place) const {
  if (is_distant()) return steady_;
  const dvec3 way = place - 0.5 * (box_.lower + box_.upper);
  const dvec3 half = 0.5 * (box_.upper - box_.lower);
  const double distance2 = glm::dot(way, way), radius2 = glm::dot(half, half);
  const double full = falling_ / std::max({distance2, radius2, kLeastSquare}) + steady_;
  if (cos_normals_ == -1.0 || !(distance2 > radius2)) return full;
  const double cosine = std::clamp(glm::dot(axis_, way) / std::sqrt(distance2), -1.0, 1.0);
  const Angle off_axis{cosine, std::sqrt(1.0 - cosine * cosine)};
  // The box seen from the place is within this angle of its middle.
  const double sine2 = radius2 / distance2;
  const Angle box{std::sqrt(1.0 - sine2), std::sqrt(sine2)};
  const Angle off = off_axis.less({cos_normals_, sin_normals_}).less(box);
  // cos(spread + e) > cos(spread) - e sin(spread) - e^2.
  if (off.cosine < cos_spread_ - kAngleError * (sin_spread_ + kAngleError)) return 0.0;
  return full * std::max(kAngleError, off.cosine);
}

LightReach LightReach::joined(const LightReach& other) const {
  const Directions both = abbe::joined({axis_, normals()}, {other.axis_, other.normals()});
  return LightReach(box_.joined(other.box_), falling_ + other.falling_, steady_ + other.steady_)
      .along(both.axis, both.half_angle, std::max(spread(), other.spread()));
}

double LightReach::solid_angle() const {
  const double widest = std::min(normals() + spread(), pi);
  return 2.0 * pi * (1.0 - cos_normals_) + 0.5 * pi *
                                               (2.0 * (widest - normals()) * sin_normals_ -
                                                std::cos(normals() - 2.0 * widest) + cos_normals_);
}

LightReach reach_from(const dvec3& position, Falloff falloff, double value) {
  const bool falls = falloff == Falloff::square;
  return {{position, position}, falls ? value : 0.0, falls ? 0.0 : pi * value};
}

} // namespace abbe
