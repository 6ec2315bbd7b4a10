#pragma once

#include "core/film/film.h"
#include "core/image/relative_error.h"
#include "spectral/color.h"

#include <optional>
#include <vector>

namespace abbe::bench {

/// How far an image is from its reference.
struct ImageError {
  double rel_mse = 0.0;             ///< see `relative_mse`
  double rmse_xyz = 0.0;            ///< over pixels and X, Y, Z
  double mean_delta_e = 0.0;        ///< CIEDE2000, mean over the pixels
  double delta_e_95 = 0.0;          ///< its 95th percentile
  std::optional<double> band_noise; ///< see below; where asked for
};

/// Colours are compared under D65 at Y = 1, the white of a display.
[[nodiscard]] ImageError image_error(const std::vector<Xyz>& image,
                                     const std::vector<Xyz>& reference);

/// The mean over bands of mean (x - r)^2 over mean r^2, both over pixels; bands in which the
/// reference is black do not count. Both films keep as many bands.
[[nodiscard]] double band_noise(const Film& image, const Film& reference);

/// How many pixels differ, be it by a bit, in colour, coverage or a band. The films have one window
/// and keep as many bands.
[[nodiscard]] std::size_t changed_pixels(const Film& a, const Film& b);

/// The image's colours, row by row.
[[nodiscard]] std::vector<Xyz> pixels(const Film& film);

} // namespace abbe::bench
