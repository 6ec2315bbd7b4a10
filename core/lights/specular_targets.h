#pragma once

#include "core/lights/emission_goals.h"
#include "core/plan/plan.h"

#include <vector>

namespace abbe {

/// The shapes that light paths may go by: balls around those that mirror or refract.
[[nodiscard]] std::vector<EmissionTarget> specular_targets(const Scene& scene, const Plan& plan);

/// The same shapes for parallel light. A mirror without end is met by light that comes to it on
/// the line to the ball about all shapes with an end and the eye: light that goes through that
/// ball's mirror image.
[[nodiscard]] ParallelTargets parallel_targets(const Scene& scene, const Plan& plan);

} // namespace abbe
