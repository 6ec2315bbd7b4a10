#pragma once

#include "core/image/image.h"
#include "spectral/color_space.h"
#include "spectral/matrix3.h"

namespace abbe {

/// From XYZ to a scene-linear space. The ACES spaces have another white than D65, which lies where
/// (1, 1, 1) does in Rec. 709: Bradford's adaptation takes white to white, as colour pipelines that
/// read the tags expect.
[[nodiscard]] Matrix3 matrix_to(SceneLinearSpace space);

/// Its primaries and white.
[[nodiscard]] ColorSpace space_of(SceneLinearSpace space);

/// A value as pictures have it. What is beyond single precision becomes the largest number there.
[[nodiscard]] float as_float(double value);

} // namespace abbe
