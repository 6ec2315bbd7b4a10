#include "core/lights/scene_extent.h"

#include "core/lights/light_kinds.h"

#include <glm/geometric.hpp>

namespace abbe {

double scene_size(const Scene& scene) {
  Bounds box;
  for (const PlacedShape& shape : scene.shapes)
    if (is_bounded(shape.shape)) box = box.joined(bounds(shape));
  for (const Light& light : scene.lights)
    if (const auto place = position(light)) box = box.joined({*place, *place});
  return box.empty() ? 0.0 : glm::length(box.upper - box.lower);
}

} // namespace abbe
