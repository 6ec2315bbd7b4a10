#pragma once

#include "geometry/world/shape.h"
#include "tests/geometry/random.h"

#include <string>
#include <vector>

namespace abbe::stress {

using reference::Random;

/// Shapes that rays are sent through, within some `size` of `middle`.
struct RayScene {
  std::string name;
  std::vector<PlacedShape> shapes;
  double size = 1.0;
  dvec3 middle{0.0};
};

/// The zoo: shapes of one kind at random proportions, sizes and places. Each of the kinds comes
/// back after `kKindsOfScenes` numbers.
inline constexpr int kKindsOfScenes = 16;
[[nodiscard]] RayScene ray_scene(int kind, Random& random);

} // namespace abbe::stress
