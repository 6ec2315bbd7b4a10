#pragma once

#include "core/scene/scene.h"
#include "spectral/band_grid.h"

#include <cstddef>
#include <vector>

namespace abbe {

/// The quantum of the film's sums: a power of two that is small against anything the scene can
/// show: 2^-36 of its brightest source. Lights that fall off count at a sixteenth of the
/// scene's size. Sums then hold 2^27 times the brightest source.
[[nodiscard]] double film_quantum(const Scene& scene, const BandGrid& grid, Observer observer);

/// The numbers, from 1, of the lights that are so faint beside the brightest source that a camera
/// sample of theirs is less than half of the quantum, so that the film keeps nothing of it.
[[nodiscard]] std::vector<std::size_t>
lights_below_quantum(const Scene& scene, const BandGrid& grid, Observer observer);

/// Throws UserError, with the name of what is too far, unless the camera, all lights and
/// all shapes have coordinates of 1e17 at most and some of them has one of 1e-30. Embree drops what
/// reaches beyond 1.8e18 or is too small for single precision, and rays would meet nothing.
void check_extent(const Scene& scene);

/// The largest magnitude of a coordinate at which the scene has a shape, a light or its camera.
[[nodiscard]] double farthest_coordinate(const Scene& scene);

} // namespace abbe
