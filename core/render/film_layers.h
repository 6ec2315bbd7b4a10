#pragma once

#include "core/film/film.h"
#include "core/plan/plan.h"

#include <optional>
#include <vector>

namespace abbe {

/// The layers of the film of a rendering, which keeps the bands of each pixel where `bands` says
/// so.
[[nodiscard]] std::vector<LayerForm> film_layers(const Scene& scene, const Plan& plan,
                                                 const std::optional<BandPlace>& bands);

} // namespace abbe
