#pragma once

#include "core/scene/scene.h"

namespace abbe {

/// Where a lamp stands; none for parallel light, which comes from infinitely far away.
[[nodiscard]] std::optional<dvec3> position_of(const Light& light);

/// The diagonal of the box around all shapes (but endless ones) and lamps, in scene units.
[[nodiscard]] double scene_size(const Scene& scene);

} // namespace abbe
