#pragma once

#include "core/scene/scene.h"
#include "io/settings/setting_text.h"
#include "io/text/read_error.h"

#include <string_view>
#include <vector>

namespace abbe {

/// A keyword of the whole scene, and where it stood last.
struct GivenKeyword {
  std::string_view keyword; ///< as its table has it
  SourcePosition where;
};
using GivenKeywords = std::vector<GivenKeyword>;

/// Notes a keyword if its effect hangs on the rest of the scene or its settings.
void note_given(GivenKeywords& given, std::string_view keyword, const SourcePosition& where);

/// Notes the first light for which light paths cannot be followed, which `caustics on` refuses.
void note_light(GivenKeywords& given, const Light& light, const SourcePosition& where);

/// Throws ReadError at the noted light where `caustics on` asks for its light paths.
void check_caustics(const GivenKeywords& given, const RenderSettings& settings);

/// Warns of keywords and options of the command line that have no effect: lightPaths with the
/// integrator whitted, focusDistance with a pinhole. A keyword of the scene is not blamed for what
/// an option has changed.
void warn_of_settings(const Scene& scene, const GivenKeywords& given,
                      const SettingsOverride& options, const Warn& warn);

} // namespace abbe
