#pragma once

#include "core/cameras/lens_system.h"

#include <optional>

namespace abbe {

/// Where parallel light of one wavelength meets a plane behind a lens.
struct LensSpot {
  double middle = 0.0;     ///< of its rays, off the axis, in mm
  double rms_radius = 0.0; ///< root of the mean square distance from their middle, in mm
  int rays = 0;            ///< that came through
};

/// Traces rays of parallel light at an angle to the axis, evenly spread over the first surface's
/// clear aperture, to the plane `film_distance` behind the last vertex. Empty where none comes
/// through.
[[nodiscard]] std::optional<LensSpot> lens_spot(const LensSystem& lens, double lambda_nm,
                                                double field_deg, double film_distance);

} // namespace abbe
