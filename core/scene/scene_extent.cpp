#include "core/scene/scene_extent.h"

#include <glm/geometric.hpp>

#include <variant>

namespace abbe {

std::optional<dvec3> position_of(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light.emitter)) return point->position;
  if (const auto* spot = std::get_if<SpotLight>(&light.emitter)) return spot->position;
  return std::nullopt;
}

double scene_size(const Scene& scene) {
  Bounds box;
  for (const PlacedShape& shape : scene.shapes)
    if (is_bounded(shape.shape)) box = box.joined(bounds(shape));
  for (const Light& light : scene.lights)
    if (const auto position = position_of(light)) box = box.joined({*position, *position});
  return box.empty() ? 0.0 : glm::length(box.upper - box.lower);
}

} // namespace abbe
