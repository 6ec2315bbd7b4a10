#pragma once

#include "core/cameras/lens_system.h"
#include "core/scene/camera.h"

namespace abbe {

/// A camera's lens with its stop, film and focus as the camera asks for them. Lengths are in mm.
struct FocusedLens {
  LensSystem lens;
  double film_distance;  ///< from the last vertex
  double focus_distance; ///< from the first vertex to what is sharp at the d line; may be infinite
  double film_height;    ///< of the whole image

  /// The tangent of the angle that the whole image's height has, seen from the first vertex.
  [[nodiscard]] double image_slope() const;
};

/// Sets up a camera's lens. Throws std::invalid_argument when that is impossible:
/// the aperture is too wide, or the focus is too near.
[[nodiscard]] FocusedLens focused_lens(const RealLens& lens, const Camera& camera,
                                       double mm_per_unit);

} // namespace abbe
