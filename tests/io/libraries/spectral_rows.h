#pragma once

#include "io/images/write_exr.h"

#include <filesystem>

namespace abbe::test {

/// Some rows of a spectral picture.
inline SpectralImage rows_of(const SpectralImage& image, const PixelWindow& rows) {
  SpectralImage part{image.display, rows, image.wavelengths_nm, {}, {}, image.metadata};
  const auto first = static_cast<std::ptrdiff_t>(rows.y0 - image.data.y0) * image.data.width();
  const auto count = static_cast<std::ptrdiff_t>(rows.pixel_count());
  const auto pixels = static_cast<std::ptrdiff_t>(image.data.pixel_count());
  for (std::size_t b = 0; b < image.wavelengths_nm.size(); ++b) {
    const auto at = image.values.begin() + static_cast<std::ptrdiff_t>(b) * pixels + first;
    part.values.insert(part.values.end(), at, at + count);
  }
  part.rgba.assign(image.rgba.begin() + 4 * first, image.rgba.begin() + 4 * (first + count));
  return part;
}

/// Writes a spectral picture that is there as a whole.
inline void write_whole_spectral_exr(const std::filesystem::path& path,
                                     const SpectralImage& image) {
  write_spectral_exr(path, image.data,
                     [&](const PixelWindow& rows) { return rows_of(image, rows); });
}

} // namespace abbe::test
