#pragma once

#include "core/film/film.h"

#include <optional>
#include <vector>

namespace abbe {

// What a limit of depth takes from the image, in layers of the film that are no part of the image.
// Their values come from BeyondLimit (core/integrators/beyond_limit.h).

inline constexpr const char* kLost = "lost";              ///< as a mean over camera samples
inline constexpr const char* kLostSplats = "lost.splats"; ///< over light passes

[[nodiscard]] std::vector<LayerForm> lost_light_layers(double quantum, bool splats);

/// What such a layer holds of a luminance: x is the luminance, y its square in a unit of its own.
[[nodiscard]] Xyz lost_light(double luminance, double quantum);

/// Which part of all light the limit has taken, with the standard error of this estimate.
struct LostShare {
  double share = 0.0, error = 0.0;
};
/// Nothing for a film without such layers, and for one without light.
[[nodiscard]] std::optional<LostShare> lost_share(const Film& film);

} // namespace abbe
