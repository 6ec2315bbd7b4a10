#pragma once

#include "core/plan/plan.h"
#include "geometry/world/world.h"

#include <optional>

namespace abbe {

/// The wavelength in nm at which mirrors and glass turn this camera ray least: a ray that comes a
/// little from the left, and one that comes a little from the right, in the plane in which the ray
/// is turned, are turned by as much. Nothing where the bands hold no such wavelength, or where such
/// rays meet other surfaces.
[[nodiscard]] std::optional<double> least_deviation_nm(const Plan& plan, const World& world,
                                                       const RayState& state);

} // namespace abbe
