#pragma once

#include "core/integrators/photon_map.h"

#include <span>

namespace abbe {

/// Photons within the first pass's radius about the median photon, whatever bands they carry.
inline constexpr int kPhotonsWithin = 64;

/// The radius of the photon map's first pass, by how close its photons lie; at most `largest`,
/// which it is where they tell nothing.
[[nodiscard]] double first_photon_radius(std::span<const PhotonBatch> batches, double largest);

/// The radius of the pass: its square shrinks as pass^(-1/2), faster than where [Knaus11] balances
/// blur and noise on smooth light, since caustics have sharp borders. There the squared error falls
/// with the radius, so the error as pass^(-1/8) to pass^(-1/4), on smooth light as pass^(-1/2);
/// noise falls as pass^(-1/4) to pass^(-1/2), the more of the radius a pixel covers the faster.
[[nodiscard]] double photon_radius(double first_radius, int pass);

} // namespace abbe
