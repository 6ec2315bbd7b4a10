#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Decides what the sky does to the film, once the plan has its environment. The sums over bands
/// that can carry light are left to plan_bands.
void plan_sky(const Scene& scene, Plan& plan);

} // namespace abbe
