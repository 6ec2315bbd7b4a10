#pragma once

#include "core/scene/settings.h"

namespace abbe {

/// Puts numbers and choices in the place of what is automatic about samples. Throws
/// UserError for adaptive sampling together with a noise target.
void plan_samples(RenderSettings& settings);

} // namespace abbe
