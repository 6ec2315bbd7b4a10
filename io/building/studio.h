#pragma once

#include "core/scene/scene.h"

namespace abbe {

// For scenes that come without a camera or without light, as models from other programs do.

/// Points the camera at all bounded shapes, from the front, the right and a little above, so that
/// they fill the picture whatever its format.
void fit_camera(Scene& scene);

/// Surrounds the scene with a studio: walls in grey, brighter above, and three soft boxes. A white
/// surface that faces the front has about the radiance of the display's white.
void add_studio_light(Scene& scene);

} // namespace abbe
