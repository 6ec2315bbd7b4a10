#pragma once

#include "core/scene.h"

#include <glm/vec2.hpp>

namespace abbe {

/// The pinhole camera of a scene, ready to shoot rays through an image of a given size.
class CameraRays {
public:
  CameraRays(const Camera& camera, int width, int height);

  /// The ray through a point of the image in pixels; (0, 0) is the upper left corner of the image.
  [[nodiscard]] Ray ray(const glm::dvec2& position) const;
  /// Where a world point appears, in pixels; nothing when it is not in front of the camera.
  [[nodiscard]] std::optional<glm::dvec2> project(const dvec3& point) const;
  [[nodiscard]] const dvec3& eye() const { return eye_; }
  /// The unit direction of view.
  [[nodiscard]] const dvec3& forward() const { return forward_; }
  /// Width of a pixel in the middle of the image as seen from the eye, in radians.
  [[nodiscard]] double pixel_angle() const { return pixel_angle_; }

private:
  dvec3 eye_, right_, down_, forward_; ///< right_ and down_ span one pixel at unit distance
  glm::dvec2 center_;
  double pixel_angle_;
};

} // namespace abbe
