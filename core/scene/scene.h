#pragma once

#include "core/scene/display_settings.h"
#include "core/scene/environment.h"
#include "core/scene/lens_prescription.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/scene/settings.h"
#include "geometry/shape.h"
#include "spectral/curve.h"

#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// A camera: a pinhole, a thin lens where `aperture` is above 0, or a real `lens`. `eye` is the
/// pinhole, the thin lens's middle, or the first vertex of the real one.
struct Camera {
  dvec3 eye{0.0, 0.0, 5.0};
  dvec3 look_at{0.0};
  dvec3 up{0.0, 1.0, 0.0};
  double field_of_view_deg = 30.0; ///< vertical

  /// Diameter of the entrance pupil, in scene units. 0 leaves a real lens as open as it is.
  double aperture = 0.0;
  /// From the eye, may be infinite; none: that of look_at.
  std::optional<double> focus_distance = std::nullopt;

  std::optional<LensPrescription> lens = std::nullopt;
  /// From the real lens's last vertex; it replaces the focus distance.
  std::optional<double> film_distance_mm = std::nullopt;
  std::optional<double> film_height_mm = std::nullopt; ///< none: as the field of view asks
  bool lens_coating = true; ///< no light is reflected inside the real lens
};

/// A scene as plain values. Nothing is looked up by name after reading.
struct Scene {
  std::string title; ///< the file's name without folder and extension
  Camera camera;
  RenderSettings settings;
  DisplaySettings display;
  double mm_per_unit = 1.0; ///< length of one scene unit

  std::vector<PlacedShape> shapes;
  std::vector<Material> materials; ///< by MaterialId
  std::vector<Medium> media;       ///< by MediumId
  std::vector<Light> lights;
  std::vector<ReflectanceImage> images; ///< of textures

  Curve background = Curve::constant(0.0);     ///< radiance where a ray meets nothing
  std::optional<Environment> environment;      ///< the same by direction; it adds to the background
  Curve global_ambient = Curve::constant(0.0); ///< the thesis's stand-in for indirect light
};

} // namespace abbe
