#pragma once

#include "core/film.h"
#include "core/plan.h"
#include "spectral/gamut.h"

namespace abbe {

/// How a picture is prepared for a screen. None of it touches scene-linear or spectral images.
struct DisplaySettings {
  double exposure_ev = 0.0; ///< brightness is multiplied by 2^exposure
  GamutMapping gamut = GamutMapping::desaturate;
};

[[nodiscard]] SceneLinearImage develop_scene_linear(const Film& film, const Plan& plan);
[[nodiscard]] DisplayImage develop_display(const Film& film, const Plan& plan,
                                           const DisplaySettings& settings);
/// The film must keep bands.
[[nodiscard]] SpectralImage develop_spectral(const Film& film, const Plan& plan);

/// The settings that made the picture, as name and value. Nothing of the machine, the time or the
/// number of threads.
[[nodiscard]] Metadata render_metadata(const Plan& plan);

} // namespace abbe
