#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/largest_component.h"
#include "geometry/rays/ray.h"

#include <glm/mat3x3.hpp>

namespace abbe {

/// An axis-aligned box; empty while lower > upper.
struct Bounds {
  dvec3 lower{1e300};
  dvec3 upper{-1e300};

  [[nodiscard]] bool empty() const {
    return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z;
  }
  [[nodiscard]] double largest_coordinate() const;
  [[nodiscard]] Bounds joined(const Bounds& other) const;
  [[nodiscard]] Bounds overlap(const Bounds& other) const;
  [[nodiscard]] Bounds grown(double margin) const;
};

/// An invertible affine map x -> linear * x + offset, kept with its inverse.
class Transform {
public:
  Transform() = default;
  /// Throws std::invalid_argument when `linear` has no inverse.
  Transform(const glm::dmat3& linear, const dvec3& offset);

  [[nodiscard]] static Transform translation(const dvec3& offset);
  [[nodiscard]] static Transform scaling(const dvec3& factors);
  /// Right-handed rotation about `axis` (any length but zero).
  [[nodiscard]] static Transform rotation(double angle_deg, const dvec3& axis);

  /// First `inner`, then this.
  [[nodiscard]] Transform after(const Transform& inner) const;
  [[nodiscard]] Transform inverse() const;

  [[nodiscard]] dvec3 point(const dvec3& p) const { return linear_ * p + offset_; }
  [[nodiscard]] dvec3 vector(const dvec3& v) const { return linear_ * v; }
  [[nodiscard]] dvec3 inverse_point(const dvec3& p) const { return inverse_ * (p - offset_); }
  [[nodiscard]] dvec3 inverse_vector(const dvec3& v) const { return inverse_ * v; }
  /// Maps a surface normal (by the inverse transpose); the result has unit length.
  [[nodiscard]] dvec3 normal(const dvec3& n) const;
  /// Bound on the rounding error of inverse_point(p), given that of p. Row by row, x - offset and
  /// the products with the inverse (itself rounded once) round five times numbers that add up to
  /// at most inverse_norm_ (|p| + |offset|). The bound includes as much again, with the image of
  /// the unit cube in place of p, for what point() loses afterwards.
  [[nodiscard]] double inverse_error(const dvec3& p, double p_error) const {
    return mapping_error(inverse_norm_, p, p_error, image_size_);
  }
  /// The same for inverse_vector(v).
  [[nodiscard]] double inverse_vector_error(const dvec3& v, double v_error) const {
    return mapping_error(inverse_norm_, v, v_error, 0.0);
  }
  [[nodiscard]] static double mapping_error(double inverse_norm, const dvec3& v, double v_error,
                                            double image_size) {
    return inverse_norm * (v_error + 8.0 * kRoundoff * (largest_component(v) + image_size));
  }

  [[nodiscard]] const glm::dmat3& linear() const { return linear_; }
  [[nodiscard]] const glm::dmat3& inverse_linear() const { return inverse_; }
  [[nodiscard]] const dvec3& offset() const { return offset_; }
  [[nodiscard]] double inverse_norm() const { return inverse_norm_; }
  [[nodiscard]] double image_size() const { return image_size_; }
  /// Box around the mapped box.
  [[nodiscard]] Bounds box(const Bounds& bounds) const;
  /// Box around the mapped unit sphere, exact for every affine map.
  [[nodiscard]] Bounds unit_sphere_box() const;
  /// Box around the mapped disc of this radius about the z axis at height `z`.
  [[nodiscard]] Bounds disc_box(double z, double radius) const;

private:
  glm::dmat3 linear_{1.0};
  dvec3 offset_{0.0};
  glm::dmat3 inverse_{1.0};
  double inverse_norm_ = 1.0; ///< largest sum of a row's magnitudes
  double image_size_ = 1.0;   ///< largest coordinate that an image of the unit cube can have
};

} // namespace abbe
