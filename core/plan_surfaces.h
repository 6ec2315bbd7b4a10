#pragma once

#include "core/plan.h"

namespace abbe {

/// Roughness, film and coat of a material, the indices of the last two as layers of the plan.
void plan_surface(const Material& material, MaterialPlan& planned, Plan& plan);

/// Says what the integrator does not show of rough surfaces.
void note_surfaces(Plan& plan);

} // namespace abbe
