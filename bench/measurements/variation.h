#pragma once

#include "core/scene/settings.h"

#include <string>
#include <string_view>
#include <vector>

namespace abbe::bench {

/// Settings to compare, named by the text that made them.
struct Variation {
  std::string name;
  RenderSettings settings;
};

/// What a variation may say, as the table of settings has it: "bands=n, jitter=on|off, exact, ...".
[[nodiscard]] std::string variation_words();

/// "default", or words of `variation_words` joined by commas. Throws UserError for anything else.
[[nodiscard]] Variation parse_variation(std::string_view text, const RenderSettings& settings);

} // namespace abbe::bench
