#pragma once

#include "io/settings/setting_text.h"
#include "io/states/state_info.h"

#include <string>

namespace abbe {

/// Those of a plan.
[[nodiscard]] KeptSettings kept_settings(const RenderSettings& settings);

/// The settings with those that were kept in their place, but for settings that were `given` on the
/// command line.
[[nodiscard]] RenderSettings with_kept(RenderSettings settings, const KeptSettings& kept,
                                       const SettingsOverride& given);

/// Says in what the settings of a plan differ from those that were kept: "--seed 3, not 7"; empty
/// where they do not.
[[nodiscard]] std::string difference(const KeptSettings& kept, const RenderSettings& settings);

} // namespace abbe
