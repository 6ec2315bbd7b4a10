#pragma once

#include "core/scene/lens_prescription.h"

#include <glm/vec3.hpp>

#include <optional>
#include <variant>

namespace abbe {

using glm::dvec3;

/// All light comes through the eye, a point.
struct Pinhole {};

/// A lens without thickness. What lies in the plane of focus is seen as through a pinhole in its
/// middle, which is the eye; everything else is blurred.
struct ThinLens {
  double aperture = 0.0; ///< its diameter, in scene units; above 0
  /// From the eye to what is sharp, may be infinite; none: that of look_at.
  std::optional<double> focus_distance = std::nullopt;
};

/// A lens of glass. The eye is the vertex of its first surface.
struct RealLens {
  LensPrescription prescription;
  /// Diameter of the entrance pupil, in scene units. 0 leaves the lens as open as it is.
  double aperture = 0.0;
  /// From the eye to what is sharp, may be infinite; none: that of look_at.
  std::optional<double> focus_distance = std::nullopt;
  /// From the last vertex; it replaces the focus distance.
  std::optional<double> film_distance_mm = std::nullopt;
  std::optional<double> film_height_mm = std::nullopt; ///< none: as the field of view asks
  bool coating = true;                                 ///< no light is reflected inside the lens
};

/// All kinds of cameras. The functions that each kind has, and that a new one needs, are listed in
/// core/cameras/camera.h.
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
