#pragma once

#include "io/readings/picture_colors.h"

#include <filesystem>
#include <vector>

namespace abbe {

/// The difference of one band.
struct BandDifference {
  double nm = 0.0;
  double rmse = 0.0;     ///< root of the mean square of the difference
  double relative = 0.0; ///< that over the root of the mean square of the reference; 0 where both
                         ///< are 0
};

/// How far a picture is from its reference.
struct PictureDifference {
  PixelWindow window;
  double rmse = 0.0;                                                ///< over pixels and linear sRGB
  double rel_mse = 0.0;                                             ///< see `relative_mse`
  double mean_delta_e = 0.0, delta_e_95 = 0.0, worst_delta_e = 0.0; ///< CIEDE2000
  std::size_t not_finite = 0; ///< pixels that have no numbers in one of them, and are left out
  std::vector<BandDifference> bands; ///< where both have bands of the same wavelengths
  std::vector<float> delta_e;        ///< of each pixel; not a number for those left out
};

/// Compares two files pixel by pixel; the second is the reference. Differences of colours are under
/// `white` with Y = 1. Throws UserError for files that cannot be read, whose windows differ, or
/// that have not one pixel with numbers in both.
[[nodiscard]] PictureDifference compare_pictures(const std::filesystem::path& picture,
                                                 const std::filesystem::path& reference,
                                                 const ColorSource& source,
                                                 const Chromaticity& white);

/// The differences of colours as a picture in false colours: dark violet for 0, over blue and
/// green to yellow for `most` and beyond; white where a pixel has no numbers.
[[nodiscard]] DisplayImage false_color(const PictureDifference& difference, double most);

} // namespace abbe
