#pragma once

#include <array>
#include <optional>

namespace abbe {

/// Rows of a matrix that is multiplied from the left by a point as a row, (x, y, z, 1).
using Matrix4 = std::array<std::array<double, 4>, 4>;

/// Where the points of a scene are for its camera, as OpenEXR's standard attributes have it.
struct CameraMatrices {
  /// To coordinates whose x goes right in the image, y up and z in the direction of the view.
  Matrix4 world_to_camera;
  /// To places in the image, (0, 0) at its upper left corner and (1, 1) at its lower right one.
  /// Empty for a real lens, which distorts.
  std::optional<Matrix4> world_to_image;
};

} // namespace abbe
