#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/local_ray.h"

#include <algorithm>
#include <optional>

namespace abbe {

// Solids with plane faces find their roots without bounds of error, which take more work than the
// roots: only the faces that end the interval need them, and a ray asks for one of its ends.

struct PlaneRoot {
  double t = 0.0;
  std::int32_t face = 0;
};
struct PlaneInterval {
  PlaneRoot enter{-kInfinity, 0};
  PlaneRoot exit{kInfinity, 0};
};

/// True for solids all of whose faces are plane.
template <class S>
concept PlaneFaced = requires(const S& solid, const LocalRay& ray, const FaceContact* contact) {
  root_error(solid, ray, plane_interval(solid, ray, contact)->exit) + 1.0;
};

/// Both ends of the interval with their bounds of error.
template <class S>
[[nodiscard]] std::optional<Interval> with_errors(const S& solid, const RayInFrame auto& ray,
                                                  const FaceContact* contact) {
  const auto found = plane_interval(solid, ray, contact);
  if (!found) return std::nullopt;
  const auto with_error = [&](const PlaneRoot& root) {
    return Root{root.t, root_error(solid, ray, root), {0, root.face}};
  };
  if (!contact) return Interval{with_error(found->enter), with_error(found->exit)};
  Interval inside{{found->enter.t, 0.0, {0, found->enter.face}}, with_error(found->exit)};
  inside.exit.t = std::max(0.0, inside.exit.t);
  return inside;
}

} // namespace abbe
