#pragma once

#include "geometry/interval.h"
#include "geometry/local_ray.h"

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
  with_error(solid, ray, plane_interval(solid, ray, contact)->exit).t_error;
};

/// Both ends of the interval with their bounds of error.
template <class S>
[[nodiscard]] std::optional<Interval> with_errors(const S& solid, const RayInFrame auto& ray,
                                                  const FaceContact* contact) {
  const auto found = plane_interval(solid, ray, contact);
  if (!found) return std::nullopt;
  Interval inside{with_error(solid, ray, found->enter), with_error(solid, ray, found->exit)};
  if (contact) {
    inside.enter.t_error = 0.0;
    inside.exit.t = std::max(0.0, inside.exit.t);
  }
  return inside;
}

} // namespace abbe
