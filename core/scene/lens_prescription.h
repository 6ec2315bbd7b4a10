#pragma once

#include "spectral/dispersion.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// One surface of a camera lens, as a prescription lists it: light travels along +z from the object
/// to the film, and a radius of curvature above 0 has its centre on the film's side.
struct PrescribedSurface {
  double radius_mm = 0.0;    ///< 0: flat
  double thickness_mm = 0.0; ///< to the next vertex; that of the last surface is not used
  Dispersion medium_after = ConstantIndex{1.0};
  std::optional<double> semi_diameter_mm; ///< of the clear aperture; empty: see LensSystem
  double conic = 0.0;                     ///< the conic constant; 0: a sphere
  /// The coefficients of an even asphere, of h^2, h^4 ... in mm^-1, mm^-3 ...
  std::vector<double> even_terms{};
};

/// A lens as plain values, in order from the object to the film. There is air before and behind it.
/// The index of air is 1, as glass indices are relative to air.
struct LensPrescription {
  std::string name;
  std::vector<PrescribedSurface> surfaces;
  std::size_t stop = 0; ///< the index of the surface that is the aperture stop
  std::optional<double> f_number;
  double half_field_deg = 0.0; ///< for surfaces without a semi-diameter
};

} // namespace abbe
