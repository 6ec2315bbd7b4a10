#pragma once

#include "io/readings/picture_colors.h"

#include <filesystem>
#include <vector>

namespace abbe {

/// The place of a pixel, counted from the upper left corner of the whole frame.
struct PixelPlace {
  int x = 0, y = 0;
};

/// The color of a pixel, and its spectrum where the file has bands.
struct PixelReading {
  PixelPlace place;
  Xyz color;
  std::vector<double> bands;
};

/// Pixels of a file, and the wavelengths of their bands.
struct PictureReading {
  std::vector<double> wavelengths_nm;
  Observer observer = Observer::cie1931_2deg; ///< who sees the colours
  std::vector<PixelReading> pixels;
};

/// Reads pixels, in the order in which they are asked for. Throws UserError for a file that cannot
/// be read, and for places that it does not hold.
[[nodiscard]] PictureReading read_pixels(const std::filesystem::path& file,
                                         const std::vector<PixelPlace>& places,
                                         const ColorSource& source);

/// The pixels on the straight way from one to the other, both included: as many as the longer side
/// of the way has, each the nearest to it.
[[nodiscard]] std::vector<PixelPlace> pixels_on_line(const PixelPlace& from, const PixelPlace& to);

/// Means over a part of a picture, and the standard deviations of its pixels from them.
struct RegionReading {
  std::vector<double> wavelengths_nm;
  Observer observer = Observer::cie1931_2deg;
  std::size_t pixels = 0;
  Xyz mean, deviation;
  std::vector<double> band_means, band_deviations;
};

/// Reads a part, which ends before `window.x1` and `window.y1` as a crop does. Throws UserError
/// where it has no pixel or is not all within the file's.
[[nodiscard]] RegionReading read_region(const std::filesystem::path& file,
                                        const PixelWindow& window, const ColorSource& source);

} // namespace abbe
