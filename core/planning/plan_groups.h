#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Gives each source that gives light its group, and names what layers of ids hold. Lights of one
/// name are one group, unless the scene groups them otherwise; a light without a name is "light"
/// with its number. Surfaces that emit go by the name of their material.
/// Throws UserError for a layer of a light that the scene does not have.
void plan_groups(const Scene& scene, Plan& plan);

} // namespace abbe
