#pragma once

#include "core/plan/plan.h"
#include "geometry/world/world.h"

namespace abbe {

/// The part of a mixture that a ray meets, chosen by a number in [0, 1). Parts may be mixtures
/// themselves.
[[nodiscard]] inline const MaterialPlan& part_of(const Plan& plan, const MaterialPlan& mixture,
                                                 double u) {
  const MaterialPlan* part = &mixture;
  while (part->mixture) {
    const MixturePlan& mix = *part->mixture;
    const bool first = u < mix.share;
    // What is left of the number's range is a number in [0, 1) again.
    u = first ? u / mix.share : (u - mix.share) / (1.0 - mix.share);
    part = &plan.materials[static_cast<std::size_t>(first ? mix.first : mix.second)];
  }
  return *part;
}

/// The diffuse reflectance where a ray met a surface of this material: a table of the plan, or
/// `scratch`, filled.
[[nodiscard]] inline const BandTable& diffuse_at(const Plan& plan, const World& world,
                                                 const MaterialPlan& material, const Hit& hit,
                                                 BandTable& scratch) {
  if (material.texture < 0) return material.diffuse;
  const PlacedShape& shape = world.shapes()[hit.shape.index()];
  return texture_at(plan.textures, material.texture,
                    surface_coordinates(shape, hit.face, hit.point), scratch);
}

} // namespace abbe
