#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Roughness, film and coat of a material, the indices of the last two as layers of the plan.
void plan_surface(const Material& material, MaterialPlan& planned, Plan& plan);

/// What rough surfaces return after one reflection, in tables; materials and media are planned.
void plan_albedos(Plan& plan);

/// Says what the integrator does not show of rough surfaces.
void note_surfaces(Plan& plan);

} // namespace abbe
