#pragma once

#include <span>
#include <string>
#include <vector>

namespace abbe {

/// A channel of the "OpenEXR Layout for Spectral Images" 1.0, and its wavelength.
struct SpectralChannel {
  std::string name;
  double wavelength_nm = 0.0;
};

/// The channels among these that hold bands, by ascending wavelength: what is emitted (`S0.`), or
/// where there is none of these, what is reflected (`T.`). A wavelength or frequency has a comma
/// as its decimal point and a unit with a prefix: `S0.550,5nm`, `T.5e2THz`. Polarised parts are
/// left out. (source: Fichet2021)
[[nodiscard]] std::vector<SpectralChannel> spectral_channels(std::span<const std::string> names);

} // namespace abbe
