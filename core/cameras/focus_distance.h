#pragma once

#include "core/scene/camera.h"

#include <glm/geometric.hpp>

namespace abbe {

/// How far from the eye a camera is focused, in scene units: as given, or on look_at.
[[nodiscard]] inline double focus_distance(const Camera& camera, std::optional<double> given) {
  return given.value_or(glm::distance(camera.look_at, camera.eye));
}

} // namespace abbe
