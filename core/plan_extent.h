#pragma once

#include "core/scene.h"
#include "spectral/band_grid.h"

namespace abbe {

/// A lamp's strength, for shares between lamps: the mean over the bands, since colours that the
/// eye hardly sees are light too.
[[nodiscard]] double mean_of(const Curve& spectrum, const BandGrid& grid);

/// The diagonal of the box around all shapes (but endless ones) and lamps, in scene units.
[[nodiscard]] double scene_size(const Scene& scene);

/// The quantum of the film's sums: a power of two that is small against anything the scene can
/// show: 2^-36 of its brightest source. Lamps whose light falls off count at a sixteenth of the
/// scene's size. Sums then hold 2^27 times the brightest source.
[[nodiscard]] double film_quantum(const Scene& scene, const BandGrid& grid, Observer observer);

} // namespace abbe
