#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Throws UserError for settings that make no sense (a crop outside the image, say).
[[nodiscard]] Plan make_plan(const Scene& scene, const RenderSettings& settings);

} // namespace abbe
