#pragma once

#include "core/film/film.h"
#include "core/image/display.h"
#include "core/image/image.h"
#include "core/plan/plan.h"

#include <string_view>

namespace abbe {

/// Settings that report errors add two channels: `samples`, how many a pixel has, and `error.Y`,
/// the standard error of its luminance as `Film::error` estimates it, 0 where `samples` is less
/// than two and nothing is known.
[[nodiscard]] SceneLinearImage
develop_scene_linear(const Film& film, const Plan& plan,
                     SceneLinearSpace space = SceneLinearSpace::rec709);

/// Which pixels of a film are wanted, and what of them.
struct FilmPart {
  PixelWindow window;          ///< a part of the film's
  std::string_view layer = {}; ///< empty: the colours and all layers; else this layer alone
  bool colors_only = false;
};
/// The same of a part, without metadata, which `scene_linear_metadata` has for all parts.
[[nodiscard]] SceneLinearImage develop_scene_linear(const Film& film, const Plan& plan,
                                                    SceneLinearSpace space, const FilmPart& part);
[[nodiscard]] Metadata scene_linear_metadata(const Film& film, const Plan& plan);
/// What one band adds to the picture's colours, of a film that keeps that apart.
[[nodiscard]] SceneLinearImage develop_band(const Film& film, const Plan& plan, int band,
                                            SceneLinearSpace space, const PixelWindow& part);

/// Throws std::invalid_argument for a white point that cannot be white.
[[nodiscard]] DisplayImage develop_display(const Film& film, const Plan& plan,
                                           const DisplaySettings& settings);
/// Part of the film's window. The film must keep bands.
[[nodiscard]] SpectralImage develop_spectral(const Film& film, const Plan& plan,
                                             const PixelWindow& part);
[[nodiscard]] inline SpectralImage develop_spectral(const Film& film, const Plan& plan) {
  return develop_spectral(film, plan, film.window());
}

} // namespace abbe
