#pragma once

#include "io/text/token.h"
#include "spectral/curve.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// One entry of a light library.
struct LightSpectrum {
  std::string name;
  double intensity = 1.0;
  Curve colour = Curve::constant(1.0); ///< relative to the equal-energy spectrum
  std::vector<std::string> remarks;    ///< what the reader warned of
};

/// The light's value per wavelength: colour times intensity.
[[nodiscard]] Curve spectrum(const LightSpectrum& light);

/// Reads a light library (*.filter). Throws ReadError.
[[nodiscard]] std::vector<LightSpectrum> read_lights(const std::filesystem::path& file,
                                                     const Warn& warn);

/// The same from a text in memory; `file` is only for messages.
[[nodiscard]] std::vector<LightSpectrum>
read_lights_text(std::string_view text, const std::string& file, const Warn& warn);

} // namespace abbe
