#pragma once

#include "core/bundles/path_wavelengths.h"

namespace abbe {

/// Bands [first, last) of a path at its hit, as a BSDF sees them: with the indices of the two media
/// and of the BSDF's own layer at the path's wavelengths, valid until these change. Directions,
/// throughput and ground are the caller's to fill in.
[[nodiscard]] Incidence surface_incidence(const Bsdf& bsdf, const Hit& hit, BandRange bands,
                                          PathWavelengths& wavelengths);

} // namespace abbe
