#pragma once

#include "core/plan/camera_matrices.h"
#include "core/scene/scene.h"

namespace abbe {

/// The matrices of the scene's camera for an image of this size.
[[nodiscard]] CameraMatrices camera_matrices(const Camera& camera, int width, int height);

} // namespace abbe
