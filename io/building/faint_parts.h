#pragma once

#include "core/scene/scene.h"
#include "io/building/setting_effects.h"
#include "io/settings/setting_text.h"

namespace abbe {

/// Warns of minReflectivity and minTransparency where they leave out what materials of the scene
/// reflect or let through, at the keyword or with the option that asked for it.
void warn_of_faint_parts(const Scene& scene, const GivenKeywords& given,
                         const SettingsOverride& options, const Warn& warn);

} // namespace abbe
