#pragma once

#include "geometry/local_ray.h"
#include "geometry/wide.h"

namespace abbe {

/// A transform's way in, laid out for rays: one vector instruction works on all three coordinates.
/// Operations and their order are those of Transform::inverse_point and its kin, and so are the
/// bits.
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

  /// A ray seen from the frame, as by abbe::local_ray. Its bounds of error are worked out when
  /// asked for: most rays miss. The frame and the ray must stay as long.
  struct SeenRay {
    dvec3 origin, direction;
    const Frame* frame;
    const Ray* ray;
    Wide wide_o, wide_d; ///< the same once more

    [[nodiscard]] dvec3 at(double t) const { return origin + t * direction; }
    [[nodiscard]] double shift_at(double t, double size) const {
      return with_errors().shift_at(t, size);
    }
    [[nodiscard]] LocalRay with_errors() const {
      return {origin, direction,
              Transform::way_error(frame->inverse_norm_, ray->origin, 0.0, frame->image_size_),
              Transform::way_error(frame->inverse_norm_, ray->direction, 0.0, 0.0)};
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

private:
  [[nodiscard]] Wide mapped(double x, double y, double z) const {
    return columns_[0] * x + columns_[1] * y + columns_[2] * z;
  }

  Wide columns_[3];
  dvec3 offset_;
  double inverse_norm_, image_size_;
};

} // namespace abbe
