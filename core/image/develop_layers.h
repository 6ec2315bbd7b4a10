#pragma once

#include "core/film/film.h"
#include "core/image/image.h"
#include "core/plan/plan.h"
#include "spectral/color.h"

#include <string_view>

namespace abbe {

/// The layer that a channel belongs to: what stands before its last dot, without the number that
/// Cryptomatte adds. A channel without a dot is a layer of its own.
[[nodiscard]] std::string_view layer_of(std::string_view channel);

/// Adds the layers that the plan's settings ask for to a picture of the film: their pixels in the
/// picture's data window. `to_rgb` takes XYZ to the picture's space. Where `layer` is not empty,
/// only the layer of that name is added.
void develop_layers(const Film& film, const Plan& plan, const Matrix3& to_rgb,
                    std::string_view layer, SceneLinearImage& image);
/// What a picture's file is to say of its layers.
[[nodiscard]] Metadata layer_metadata(const Plan& plan);

} // namespace abbe
