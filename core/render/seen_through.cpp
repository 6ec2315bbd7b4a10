#include "core/render/seen_through.h"

#include "core/optics/fresnel.h"
#include "core/optics/shading_side.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

constexpr int kMostSurfaces = 64;

const MaterialPlan& larger_part(const Plan& plan, const Hit& hit) {
  const MaterialPlan* part = &plan.materials[hit.material.index()];
  while (part->mixture) {
    const MixturePlan& mix = *part->mixture;
    part = &plan.materials[static_cast<std::size_t>(mix.share >= 0.5 ? mix.first : mix.second)];
  }
  return *part;
}

/// The direction in which the ray goes on, whether to the other side of the surface, and whether
/// the surface would let light through to it at another angle.
struct Turn {
  dvec3 direction;
  bool through;
  bool total = false;
};

/// `through_nm` is the wavelength at a surface that lets light through.
Turn turn_at(const Plan& plan, const Hit& hit, const dvec3& direction,
             std::optional<double> through_nm) {
  const dvec3 normal = hit.facing_shading_normal();
  const auto on_side = [&](const dvec3& turned, bool above) {
    return hit.bent ? kept_on_side(turned, hit.facing_normal(), above) : turned;
  };
  const double cos_i = std::clamp(-glm::dot(direction, normal), 0.0, 1.0);
  if (through_nm) {
    const double eta = plan.medium(hit.medium_after).index.at(*through_nm) /
                       plan.medium(hit.medium_before).index.at(*through_nm);
    if (const auto cos_t = refracted_cosine(cos_i, eta))
      return {on_side(refracted(direction, normal, cos_i, *cos_t, eta), false), true};
  }
  return {on_side(reflected(direction, normal), true), false, through_nm.has_value()};
}

/// The angle between two directions of unit length; right for small angles too.
double angle_between(const dvec3& a, const dvec3& b) {
  return 2.0 * std::atan2(glm::length(a - b), glm::length(a + b));
}

} // namespace

SeenThrough see_through(const Plan& plan, const World& world, RayState state, const Hit& first,
                        double nm) {
  SeenThrough seen;
  seen.direction = state.ray.direction;
  const dvec3 begin = state.ray.direction;
  Hit hit = first;
  Passage passage;
  bool straight_on = false;
  for (int met = 0; hit.met() && met < kMostSurfaces; ++met) {
    const MediumId before = hit.medium_before;
    seen.distance += hit.t;
    if (before.valid() && !plan.media[before.index()].drops) seen.glass_length += hit.t;
    const MaterialPlan& material = larger_part(plan, hit);
    const BsdfFacts facts = material.facts();
    if (facts.passes || plan.unseen(hit)) {
      if (!straight_on) passage = {};
      straight_on = true;
      if (!passage.go_through(hit, state)) return seen;
      world.find_closest(state, kInfinity, passage, hit);
      continue;
    }
    if (!facts.specular() || facts.coats || (material.lit() && !facts.transmits)) {
      seen.end = hit;
      return seen;
    }
    const Turn turn =
        turn_at(plan, hit, state.ray.direction, facts.transmits ? std::optional(nm) : std::nullopt);
    state = hit.going_on(turn.direction, turn.through);
    straight_on = false;
    ++seen.surfaces;
    seen.total_reflections += turn.total ? 1 : 0;
    seen.direction = turn.direction;
    seen.deviation = angle_between(begin, turn.direction);
    world.find_closest(state, hit);
  }
  return seen;
}

} // namespace abbe
