#pragma once

#include "core/film/film.h"
#include "core/image/image.h"
#include "core/plan/plan.h"
#include "spectral/color.h"

namespace abbe {

/// Adds the layers that the plan's settings ask for to a picture of the film, with their metadata.
/// `to_rgb` takes XYZ to the picture's space.
void develop_layers(const Film& film, const Plan& plan, const Matrix3& to_rgb,
                    SceneLinearImage& image);

} // namespace abbe
