#pragma once

#include <optional>
#include <span>

namespace abbe {

// Ray optics of a spherical drop of index n >= 1 in air [vdH57, 12.2]. The order p of a ray
// says how it left: 0 reflected outside, 1 straight through, 2 after one reflection inside (the
// primary bow), 3 after two (the secondary), and so on. Angles in radians. Diffraction, which
// bends light by less than a minute of arc at a drop of 1 mm, is left out.

/// How far a ray of this order is turned in all, counted with full turns: D = 2 i - 2 p r +
/// (p - 1) pi, with Snell's sin i = n sin r. The scattering angle is D folded into 0 to pi.
[[nodiscard]] double drop_deviation(double n, int order, double incidence);

/// Where the deviation turns back, cos^2 i = (n^2 - 1) / (p^2 - 1); the rays crowd there to a bow.
/// None below order 2, nor where n > p.
[[nodiscard]] std::optional<double> bow_incidence(double n, int order);

/// The scattering angle of the bow; a rainbow's radius about the antisolar point is pi minus it.
[[nodiscard]] std::optional<double> bow_angle(double n, int order);

/// The share of unpolarised light that leaves with this order, of what arrives at this incidence:
/// the mean of s and p of R for order 0, else of (1 - R)^2 R^(p - 1). The plane of incidence is the
/// same at every hit, so s and p never mix.
[[nodiscard]] double drop_share(double n, int order, double incidence);

/// Adds to each of `cells`, which divide the scattering angle from 0 to pi evenly, the share of the
/// light on a drop's disc that leaves into it with the orders from `first_order` to `last_order`:
/// the integral of drop_share sin 2i di between the incidences at which D(i) crosses the cell's
/// borders. So a cell that holds a bow, where the density is infinite, gets what it should.
void add_drop_flux(double n, int first_order, int last_order, std::span<double> cells);

/// What stays inside when the orders 0 to `last_order` have left, as a share of the light on the
/// drop's disc.
[[nodiscard]] double drop_remainder(double n, int last_order);

} // namespace abbe
