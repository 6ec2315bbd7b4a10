#pragma once

#include "spectral/band_grid.h"
#include "spectral/color.h"
#include "spectral/curve.h"

#include <cstdint>
#include <vector>

namespace abbe {

/// The CIE standard observers [CIE018].
enum class Observer : std::uint8_t { cie1931_2deg, cie1964_10deg };

/// Per band, the XYZ that this band of `light` gives on a perfect reflector. The colour of a
/// surface is the sum over bands of weight times reflectance. An equal-energy light of value 1 has
/// Y = 1 for every number of bands.
///
/// With up to 81 bands the base cells are the 81 samples with the standard's 5 nm values of the
/// colour matching functions [CIE15, ASTM308]; a band folds light x observer of its cells, parts of
/// a cell in proportion, so the sum over bands does not depend on their number. With more than 81
/// bands the base cells are the 405 cells of 1 nm centred on 378 ... 782 nm, with the 1 nm table.
///
/// A spectral line gives its band the 1 nm table's colour at its own wavelength, however wide the
/// band.
[[nodiscard]] std::vector<Xyz> band_weights(const BandGrid& grid, const Curve& light,
                                            Observer observer = Observer::cie1931_2deg);

/// Per band, the mean of `light` over the same base cells: what a spectral image stores. It has the
/// unit of the light. A line's power is spread over its band.
[[nodiscard]] std::vector<double> band_means(const BandGrid& grid, const Curve& light);

/// The light's XYZ: the sum of its weights at 81 bands.
[[nodiscard]] Xyz to_xyz(const Curve& light, Observer observer = Observer::cie1931_2deg);

} // namespace abbe
