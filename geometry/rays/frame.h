#pragma once

#include "geometry/rays/local_ray.h"
#include "geometry/rays/wide.h"

namespace abbe {

/// The map from the world into a shape's frame, laid out for rays: one vector instruction works on
/// all three coordinates. The operations and their order are those of Transform::inverse_point and
/// inverse_vector, so the results have the same bits.
class Frame {
public:
  explicit Frame(const Transform& to_outer)
      : offset_(to_outer.offset()), inverse_norm_(to_outer.inverse_norm()),
        image_size_(to_outer.image_size()) {
    for (int i = 0; i < 3; ++i) {
      const dvec3& column = to_outer.inverse_linear()[i];
      columns_[i] = Wide{column.x, column.y, column.z, 0.0};
    }
  }

  /// A ray seen from the frame, as by abbe::local_ray. Its bounds of error are computed only when
  /// asked for, since most rays miss. The frame and the ray must outlive it.
  struct SeenRay {
    dvec3 origin, direction;
    const Frame* frame;
    const Ray* ray;
    Wide wide_o, wide_d; ///< `origin` and `direction` again, for vector instructions

    [[nodiscard]] dvec3 at(double t) const { return origin + t * direction; }
    [[nodiscard]] double shift_at(double t, double size) const {
      return with_errors().shift_at(t, size);
    }
    [[nodiscard]] double shift_rate() const { return with_errors().shift_rate(); }
    [[nodiscard]] LocalRay with_errors() const {
      return {origin, direction,
              Transform::mapping_error(frame->inverse_norm_, ray->origin, 0.0, frame->image_size_),
              Transform::mapping_error(frame->inverse_norm_, ray->direction, 0.0, 0.0)};
    }
    friend Wide wide_origin(const SeenRay& seen) { return seen.wide_o; }
    friend Wide wide_direction(const SeenRay& seen) { return seen.wide_d; }
  };
  [[nodiscard]] SeenRay see(const Ray& ray) const {
    const Wide o =
        mapped(ray.origin.x - offset_.x, ray.origin.y - offset_.y, ray.origin.z - offset_.z);
    const Wide d = mapped(ray.direction.x, ray.direction.y, ray.direction.z);
    return {{o[0], o[1], o[2]}, {d[0], d[1], d[2]}, this, &ray, o, d};
  }

  [[nodiscard]] dvec3 inverse_point(const dvec3& p) const {
    const Wide found = mapped(p.x - offset_.x, p.y - offset_.y, p.z - offset_.z);
    return {found[0], found[1], found[2]};
  }

private:
  [[nodiscard]] Wide mapped(double x, double y, double z) const {
    return columns_[0] * x + columns_[1] * y + columns_[2] * z;
  }

  Wide columns_[3];
  dvec3 offset_;
  double inverse_norm_, image_size_;
};

/// The map from a shape's frame into the world, for points and normals. It gives the bits of
/// Transform::point and Transform::normal.
class Placement {
public:
  explicit Placement(const Transform& to_outer) {
    const glm::dmat3 &linear = to_outer.linear(), &inverse = to_outer.inverse_linear();
    for (int i = 0; i < 3; ++i) {
      columns_[i] = Wide{linear[i].x, linear[i].y, linear[i].z, 0.0};
      inverse_rows_[i] = Wide{inverse[0][i], inverse[1][i], inverse[2][i], 0.0};
    }
    const dvec3& offset = to_outer.offset();
    offset_ = Wide{offset.x, offset.y, offset.z, 0.0};
  }

  [[nodiscard]] dvec3 point(const dvec3& p) const {
    const Wide found = columns_[0] * p.x + columns_[1] * p.y + columns_[2] * p.z + offset_;
    return {found[0], found[1], found[2]};
  }
  [[nodiscard]] dvec3 normal(const dvec3& n) const {
    const Wide m = inverse_rows_[0] * n.x + inverse_rows_[1] * n.y + inverse_rows_[2] * n.z;
    const Wide squares = m * m;
    const Wide unit = m * (1.0 / std::sqrt(squares[0] + squares[1] + squares[2]));
    return {unit[0], unit[1], unit[2]};
  }

private:
  Wide columns_[3], offset_, inverse_rows_[3];
};

} // namespace abbe
