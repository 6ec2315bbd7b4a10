#pragma once

#include "core/scene/scene.h"
#include "spectral/band_grid.h"

#include <vector>

namespace abbe {

/// For each band, the spectral lines that are all the light in it, by wavelength, their powers
/// scaled to a sum of 1; none where some source of the scene has a continuous spectrum. No list at
/// all for a scene without lines.
[[nodiscard]] std::vector<std::vector<SpectralLine>> lines_of_bands(const Scene& scene,
                                                                    const BandGrid& grid);

} // namespace abbe
