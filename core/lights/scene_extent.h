#pragma once

#include "core/scene/scene.h"

namespace abbe {

/// The diagonal of the box around all shapes (but endless ones) and lights, in scene units.
[[nodiscard]] double scene_size(const Scene& scene);

} // namespace abbe
