#pragma once

#include "core/display.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace abbe {

/// A half-open rectangle of pixels: x0 <= x < x1, y0 <= y < y1, y downwards from the top row.
struct PixelWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
  [[nodiscard]] std::size_t pixel_count() const {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  }
  friend bool operator==(const PixelWindow&, const PixelWindow&) = default;
};

/// Text that travels with a picture: names and values in the order they are written.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// Primaries and white of a scene-linear picture.
enum class SceneLinearSpace : std::uint8_t { rec709, acescg, aces2065_1, rec2020 };

/// One more value per pixel beside the colours, row by row.
struct ImageChannel {
  std::string name;
  std::vector<float> values;
};

/// Scene-linear picture, Rec. 709 primaries unless `space` says otherwise, unclipped (negative
/// values are out of gamut, not wrong), associated alpha. Channels are interleaved R, G, B, A, rows
/// from the top of `data`.
struct SceneLinearImage {
  PixelWindow display; ///< the full frame
  PixelWindow data;    ///< the part that was rendered; smaller than `display` for a crop
  std::vector<float> rgba;
  Metadata metadata;
  SceneLinearSpace space = SceneLinearSpace::rec709;
  std::vector<ImageChannel> channels = {};
};

/// Picture for a screen: exposed, brought into its gamut. Both encodings of the same pixels are
/// kept: `encoded` has the screen's transfer function, `linear` has not. Interleaved R, G, B in
/// [0, 1], no alpha, rows from the top of `data`.
struct DisplayImage {
  PixelWindow display, data;
  std::vector<float> encoded;
  std::vector<float> linear;
  Metadata metadata;
  DisplayEncoding encoding = {};
};

/// Mean spectral radiance of each band. Planes are band-major: values[band * pixels + pixel].
/// Unit: that of the scene's lights, where the equal-energy spectrum of value 1 has Y = 1.
struct SpectralImage {
  PixelWindow display, data;
  std::vector<double> wavelengths_nm; ///< band centres, ascending
  std::vector<float> values;
  std::vector<float> rgba; ///< preview, as in SceneLinearImage
  Metadata metadata;
};

} // namespace abbe
