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

/// "default", or words joined by commas: fan=N, tolerance=PIXELS, cutoff=X, bands=N, noise=X,
/// lightpaths=X, exact, jitter=on|off, integrator=whitted|path, caustics=on|off, adaptive=on|off.
/// Throws std::invalid_argument for anything else.
[[nodiscard]] Variation parse_variation(std::string_view text, const RenderSettings& settings);

} // namespace abbe::bench
