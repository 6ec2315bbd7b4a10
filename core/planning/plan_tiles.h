#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Cuts a window into tiles and finds those that no shape can show in.
[[nodiscard]] std::vector<Tile> make_tiles(const Scene& scene, const PixelWindow& window,
                                           const RenderSettings& settings);

} // namespace abbe
