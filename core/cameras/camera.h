#pragma once

#include "core/scene/scene.h"

#include <glm/vec2.hpp>

namespace abbe {

/// How far from the eye the camera is focused, in scene units.
[[nodiscard]] double focus_distance(const Camera& camera);

/// The pinhole or thin-lens camera of a scene, ready to shoot rays through an image of a given
/// size. A thin lens shows what lies in the plane of focus as the pinhole does, all else blurred; a
/// uniform radiance looks the same through both.
class CameraRays {
public:
  CameraRays(const Camera& camera, int width, int height);

  /// The ray through a point of the image in pixels; (0, 0) is the upper left corner of the image.
  [[nodiscard]] Ray ray(const glm::dvec2& position) const;
  /// The same from a point of a thin lens, which two numbers in [0, 1) choose.
  [[nodiscard]] Ray ray(const glm::dvec2& position, const glm::dvec2& lens) const;
  [[nodiscard]] bool has_aperture() const { return aperture_ > 0.0; }
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
  double aperture_, focus_distance_;
};

} // namespace abbe
