#pragma once

#include "core/image/image.h"
#include "core/render/render.h"

#include <string>

namespace abbe {

// What is likely to be a mistake in a scene that has been rendered without any error. Each returns
// one warning, or "" where nothing is to be told.

/// Says why all of the picture is black, where it is.
[[nodiscard]] std::string warning_of_darkness(const Scene& scene, const Plan& plan,
                                              const Rendering& rendering);

/// Says that every pixel is black, or every pixel brighter than white, in the picture for a screen
/// of a film that is not black.
[[nodiscard]] std::string warning_of_exposure(const Film& film, const DisplayImage& image);

} // namespace abbe
