#pragma once

#include "core/scene/lens_prescription.h"

#include <glm/vec3.hpp>

#include <optional>
#include <variant>

namespace abbe {

using glm::dvec3;

/// All light comes through one point, the eye.
struct Pinhole {};

/// A lens without thickness. What lies in the plane of focus is seen as through a pinhole in its
/// middle, which is the eye; everything else is blurred.
struct ThinLens {
  double aperture = 0.0; ///< the diameter in scene units, above 0
  /// From the eye to the plane of focus; may be infinite. Empty: the distance of look_at.
  std::optional<double> focus_distance = std::nullopt;
};

/// A lens of glass. The eye is the vertex of its first surface.
struct RealLens {
  LensPrescription prescription;
  /// Diameter of the entrance pupil, in scene units. 0 leaves the stop as the prescription has it.
  double aperture = 0.0;
  /// From the eye to the plane of focus; may be infinite. Empty: the distance of look_at.
  std::optional<double> focus_distance = std::nullopt;
  /// From the last vertex to the film. Where it is given, it replaces the focus distance.
  std::optional<double> film_distance_mm = std::nullopt;
  std::optional<double> film_height_mm = std::nullopt; ///< empty: by the field of view
  bool coating = true;                                 ///< the glass reflects no light
};

/// All kinds of cameras. core/cameras/placed_camera.h lists the functions that each kind has and
/// that a new one needs.
using CameraKind = std::variant<Pinhole, ThinLens, RealLens>;

/// Where a camera stands and looks, and which kind it is.
struct Camera {
  dvec3 eye{0.0, 0.0, 5.0};
  dvec3 look_at{0.0};
  dvec3 up{0.0, 1.0, 0.0};
  double field_of_view_deg = 30.0; ///< vertical
  CameraKind kind;
};

} // namespace abbe
