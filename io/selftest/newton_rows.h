#pragma once

#include "io/selftest/selftest_row.h"

#include <string>

namespace abbe {

/// Newton's experiment: a narrow beam goes through a prism of SF11 and falls on a wall.
[[nodiscard]] std::string newton_scene();
inline constexpr double kNewtonWall = 5.5; ///< its x

/// Where a wavelength arrives on the wall, and how much of it: by Snell's and Fresnel's laws for
/// the axis of the beam, in the plane of the prism's section.
struct NewtonArrival {
  double y;             ///< on the wall
  double transmittance; ///< of the prism's two faces
};
[[nodiscard]] NewtonArrival newton_arrival(double n);

/// The beam's flux per unit of its spectrum: its solid angle.
[[nodiscard]] double newton_beam();

/// What light paths bring to the wall: the flux of each of 81 bands, and its mean y.
struct NewtonBand {
  double flux = 0.0, y = 0.0;
};
/// Follows so many light paths. Only what arrives within 0.03 of `newton_arrival` counts, as light
/// that is thrown back inside the prism comes to other places.
[[nodiscard]] std::vector<NewtonBand> newton_wall(std::uint32_t paths);

[[nodiscard]] SelftestRows newton_rows();

} // namespace abbe
