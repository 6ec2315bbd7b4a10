#pragma once

#include "core/plan/camera_matrices.h"
#include "core/scene/display_settings.h"
#include "core/scene/pixel_window.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abbe {

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
  std::optional<CameraMatrices> camera = {}; ///< where it is known
};

/// Picture for a screen, exposed. `encoded` is brought into its gamut, so within [0, 1] but
/// for the gamut mapping `none`, and has the screen's transfer function; `linear` is the light of
/// the same primaries as it is, unclipped. Interleaved R, G, B, no alpha, rows from the top of
/// `data`.
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
  std::optional<CameraMatrices> camera = {};
};

} // namespace abbe
