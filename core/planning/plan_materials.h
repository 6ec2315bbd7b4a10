#pragma once

#include "core/planning/plan_sources.h"

#include <vector>

namespace abbe {

/// Where curves of materials are read: the bands' centres, or their lines.
[[nodiscard]] std::vector<double> table_wavelengths(const Plan& plan);

/// The scene's materials at the plan's bands; what they emit is added to the sources.
void plan_materials(const Scene& scene, Plan& plan, SourcePlanner& sources);

/// The scene's media at the plan's bands.
void plan_media(const Scene& scene, Plan& plan);

} // namespace abbe
