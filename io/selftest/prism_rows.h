#pragma once

#include "geometry/world/world.h"
#include "io/selftest/selftest_row.h"

namespace abbe {

/// A world of one solid, the thesis's prism of three equal sides.
[[nodiscard]] World prism_world();

/// The least angle in degrees by which the prism of `prism_world` turns a ray, for glass of the
/// index n in air: found among rays that are followed through the prism.
[[nodiscard]] double minimum_deviation_deg(const World& world, double n);

/// The minimum deviation of ten glasses, and by how much it differs between the lines F and C.
[[nodiscard]] SelftestRows prism_rows();

} // namespace abbe
