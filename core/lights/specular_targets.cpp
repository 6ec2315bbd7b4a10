#include "core/lights/specular_targets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace abbe {
namespace {

EmissionTarget ball_around(const Bounds& box) {
  return {0.5 * (box.lower + box.upper), 0.5 * glm::length(box.upper - box.lower)};
}

/// Calls `visit(placed, reflects, transmits)` for the shapes with a part that mirrors or refracts.
template <class Visit>
void for_each_specular(const Scene& scene, const Plan& plan, Visit&& visit) {
  for (const PlacedShape& placed : scene.shapes) {
    const bool of_drops = placed.medium.valid() && plan.medium(placed.medium).drops;
    if (of_drops && plan.materials[placed.material.index()].clear) continue; // bends no light
    bool reflects = false, transmits = false;
    const auto add = [&](MaterialId id) {
      if (!id.valid()) return;
      const BsdfFacts facts = plan.materials[id.index()].facts();
      if (!facts.specular()) return;
      reflects = reflects || facts.reflects;
      transmits = transmits || facts.transmits;
    };
    add(placed.material);
    if (const auto* tree = std::get_if<CsgTree>(&placed.shape))
      for (const auto& leaf : tree->leaves())
        add(leaf.material);
    if (reflects || transmits) visit(placed, reflects, transmits);
  }
}

} // namespace

std::vector<EmissionTarget> specular_targets(const Scene& scene, const Plan& plan) {
  std::vector<EmissionTarget> targets;
  for_each_specular(scene, plan, [&](const PlacedShape& placed, bool, bool) {
    targets.push_back(is_bounded(placed.shape)
                          ? ball_around(bounds(placed))
                          : EmissionTarget{dvec3(0.0), std::numeric_limits<double>::infinity()});
  });
  return targets;
}

ParallelTargets parallel_targets(const Scene& scene, const Plan& plan) {
  std::vector<EndlessPlane> planes;
  Bounds box{scene.camera.eye, scene.camera.eye};
  for (const PlacedShape& placed : scene.shapes) {
    if (is_bounded(placed.shape))
      box = box.joined(bounds(placed));
    else
      planes.push_back(
          {placed.to_world.point(dvec3(0.0)), placed.to_world.normal({0.0, 0.0, 1.0})});
  }
  EmissionTarget around = ball_around(box);
  // With nothing but planes, what is seen of them is about as far as they are.
  if (!(around.radius > 0.0))
    for (const EndlessPlane& plane : planes)
      around.radius =
          std::max(around.radius, std::abs(glm::dot(around.center - plane.point, plane.normal)));
  std::vector<EmissionTarget> balls;
  for_each_specular(scene, plan, [&](const PlacedShape& placed, bool reflects, bool transmits) {
    if (is_bounded(placed.shape)) {
      balls.push_back(ball_around(bounds(placed)));
      return;
    }
    if (transmits) balls.push_back(around);
    if (!reflects) return;
    const dvec3 normal = placed.to_world.normal({0.0, 0.0, 1.0});
    const double above = glm::dot(around.center - placed.to_world.point(dvec3(0.0)), normal);
    balls.push_back({around.center - 2.0 * above * normal, around.radius});
  });
  std::erase_if(balls, [](const EmissionTarget& ball) { return !(ball.radius > 0.0); });
  return {std::move(balls), around, std::move(planes)};
}

} // namespace abbe
