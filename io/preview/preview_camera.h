#pragma once

#include "core/scene/camera.h"
#include "geometry/world/world.h"
#include "io/preview/preview_wishes.h"

#include <optional>
#include <string>

namespace abbe {

/// The scene's camera, moved and opened as it is wished.
[[nodiscard]] Camera wished_camera(Camera camera, const PreviewWishes& wishes);

/// How far what is seen at a point of the image lies before the camera, along its axis. `at` goes
/// from 0 to 1 from left to right and from top to bottom of the whole frame. None where nothing is
/// met. A real lens is taken as a pinhole, which is near enough.
[[nodiscard]] std::optional<double> distance_at(const World& world, const Camera& camera,
                                                double width_over_height, const glm::dvec2& at);

/// The lines of a scene that place this camera. What its kind needs beside aperture and focus (the
/// file of a real lens) is left to the scene.
[[nodiscard]] std::string camera_lines(const Camera& camera);

} // namespace abbe
