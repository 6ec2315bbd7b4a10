#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <optional>

namespace abbe {

/// The connection of a point of the scene with a camera that sees it.
struct CameraConnection {
  glm::dvec2 film{0.0};      ///< where the point appears, in pixels from the upper left corner
  glm::dvec3 direction{0.0}; ///< unit, from the point to the camera
  double distance = 0.0;     ///< from the point to the camera
  /// Over this, a flux that the point's surface sends towards the camera, times its BSDF and
  /// cosine, adds to the mean radiance of the pixel there.
  double inverse_importance = 0.0;
};

/// Where a point of the scene appears in the image, in pixels from the upper left corner; nothing
/// when it is not in front of the camera. What is in front keeps its straight lines, so that a box
/// appears between the images of its corners. It is empty for a camera that has no such map, as one
/// that blurs.
using Projection = std::function<std::optional<glm::dvec2>(const glm::dvec3&)>;

} // namespace abbe
