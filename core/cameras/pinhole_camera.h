#pragma once

#include "core/cameras/camera_connection.h"
#include "core/cameras/image_scale.h"
#include "core/sampling/sampler.h"
#include "core/scene/camera.h"
#include "geometry/rays/ray.h"

namespace abbe {

/// A pinhole, ready to shoot rays through an image of a given size.
class PinholeCamera {
public:
  PinholeCamera(const Camera& camera, int width, int height);

  /// The ray through a point of the image in pixels; (0, 0) is the upper left corner of the image.
  [[nodiscard]] Ray ray(const glm::dvec2& film) const;
  [[nodiscard]] Ray ray(const glm::dvec2& film, const Sampler&) const { return ray(film); }
  /// See Projection.
  [[nodiscard]] std::optional<glm::dvec2> project(const dvec3& point) const;

  static constexpr bool kConnects = true;
  [[nodiscard]] std::optional<CameraConnection> connect(const dvec3& point) const;

  /// Width of a pixel in the middle of the image as seen from the eye, in radians.
  [[nodiscard]] double pixel_angle() const { return pixel_angle_; }

  /// A ray in the direction in which the eye sees a point of the image, from a point beside it by
  /// `across`, in multiples of `right_` and `down_`, that meets it at a distance along the axis.
  [[nodiscard]] Ray ray_from(const glm::dvec2& across, const glm::dvec2& film,
                             double distance) const;

private:
  dvec3 eye_, right_, down_, forward_; ///< right_ and down_ span one pixel at unit distance
  glm::dvec2 center_;
  double pixel_angle_;
};

// What PlacedCamera asks of a kind of camera; see placed_camera.h.

[[nodiscard]] PinholeCamera place(const Pinhole& kind, const Camera& camera,
                                  const ImageScale& image);
[[nodiscard]] Projection projection(const Pinhole& kind, const Camera& camera,
                                    const ImageScale& image);
[[nodiscard]] double reach(const Pinhole& kind, double mm_per_unit);

} // namespace abbe
