#pragma once

#include "geometry/world/world.h"
#include "tests/geometry/random.h"
#include "tests/geometry/reference.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace abbe::reference {

/// The shapes of a test, for the world and for the reference.
struct Scene {
  std::vector<Twin> twins;

  [[nodiscard]] std::vector<PlacedShape> shapes() const {
    std::vector<PlacedShape> placed;
    for (const Twin& twin : twins)
      placed.push_back(twin.placed);
    return placed;
  }
  [[nodiscard]] Nesting nesting(const Vec& point) const {
    Nesting found;
    for (std::size_t i = 0; i < twins.size(); ++i)
      if (twins[i].solid.contains(point)) found.push_back({static_cast<std::int32_t>(i)});
    return found;
  }
  [[nodiscard]] Real clearance(const Vec& point) const {
    Real smallest = INFINITY;
    for (const Twin& twin : twins)
      smallest = std::min(smallest, twin.solid.clearance(point));
    return smallest;
  }
  void add(Twin twin, int medium = -1, int priority = 0) {
    const auto number = static_cast<std::int32_t>(twins.size());
    twin.placed.material = {1000 + number};
    twin.placed.medium = {medium};
    twin.placed.priority = priority;
    twins.push_back(std::move(twin));
  }
};

/// A state for a ray that starts in the open or inside solids, on no surface.
[[nodiscard]] inline RayState free_ray(const Scene& scene, const dvec3& o, const dvec3& d) {
  RayState state;
  state.ray = {o, glm::normalize(d)};
  state.nesting = scene.nesting(Vec(o));
  return state;
}

struct Nearest {
  int shape = -1;
  Crossing crossing;
};

/// The first crossing ahead, by asking every shape. All boundaries count.
[[nodiscard]] inline std::optional<Nearest> nearest(const Scene& scene, const Vec& origin,
                                                    const Vec& direction) {
  std::optional<Nearest> first;
  for (std::size_t i = 0; i < scene.twins.size(); ++i)
    for (const Crossing& c : scene.twins[i].solid.crossings(origin, direction))
      if (c.t > 0 && (!first || c.t < first->crossing.t)) first = {{static_cast<int>(i), c}};
  return first;
}

[[nodiscard]] inline bool same_place(const std::optional<Nearest>& a,
                                     const std::optional<Nearest>& b) {
  if (!a || !b) return !a && !b;
  return a->shape == b->shape && a->crossing.leaf == b->crossing.leaf &&
         a->crossing.face == b->crossing.face && a->crossing.entering == b->crossing.entering;
}

/// True when moving the origin by no more than rounding changes what is met.
[[nodiscard]] inline bool undecided(const Scene& scene, const Ray& ray, double rounding) {
  const auto met = nearest(scene, Vec(ray.origin), Vec(ray.direction));
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Vec o(ray.origin);
      o[axis] += static_cast<Real>(sign * rounding);
      if (!same_place(met, nearest(scene, o, Vec(ray.direction)))) return true;
    }
  return false;
}

enum class Verdict { agrees, undecided, differs };

/// Compares a hit with the reference, for scenes in which every boundary shows.
[[nodiscard]] inline Verdict judge(const Scene& scene, const Ray& ray,
                                   const std::optional<Hit>& hit, double rounding) {
  const auto truth = nearest(scene, Vec(ray.origin), Vec(ray.direction));
  const auto fails = [&] {
    return undecided(scene, ray, rounding) ? Verdict::undecided : Verdict::differs;
  };
  if (!hit || !truth) return hit || truth ? fails() : Verdict::agrees;
  const Crossing& c = truth->crossing;
  const bool same = hit->shape.value == truth->shape && hit->face.leaf == c.leaf &&
                    hit->face.face == c.face && hit->entering == c.entering;
  if (!same) return fails();
  // A surface shifted by `rounding` is met rounding / cosine away; a curved one turns its normal
  // by as much over its radius of curvature (1/27 at least for these maps). The direction is
  // rounded too, which shifts what is met far away, on planes without end, by twice 2^-53 of the
  // way.
  const Real cosine = std::abs(glm::dot(c.normal, Vec(ray.direction)));
  const Real shift = (static_cast<Real>(rounding) + 0x1p-52L * std::abs(c.t)) / cosine;
  const bool close =
      std::abs(hit->t - c.t) <= shift &&
      glm::length(Vec(hit->point) - Vec(ray.origin) - c.t * Vec(ray.direction)) <= 2 * shift &&
      glm::length(Vec(hit->normal) - c.normal) <= 30 * shift + 1e-14L;
  return close ? Verdict::agrees : fails();
}

struct Tally {
  int agree = 0, undecided = 0, differ = 0, hits = 0;

  void add(Verdict verdict, bool hit) {
    hits += hit;
    (verdict == Verdict::agrees ? agree : verdict == Verdict::undecided ? undecided : differ)++;
  }
};

} // namespace abbe::reference
