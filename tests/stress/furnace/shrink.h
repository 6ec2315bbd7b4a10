#pragma once

#include "tests/stress/furnace/random_scene.h"

#include <functional>

namespace abbe::stress {

/// The smallest scene that can be had by leaving parts out, one at a time, while it still fails.
[[nodiscard]] RandomScene shrunk(RandomScene scene,
                                 const std::function<bool(const RandomScene&)>& fails);

} // namespace abbe::stress
