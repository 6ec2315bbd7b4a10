#pragma once

#include "core/display.h"
#include "core/lights/environment.h"
#include "core/lights/light.h"
#include "core/materials/material.h"
#include "core/settings.h"
#include "geometry/shape.h"
#include "spectral/curve.h"

#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// A pinhole camera. `field_of_view_deg` is vertical.
struct Camera {
  dvec3 eye{0.0, 0.0, 5.0};
  dvec3 look_at{0.0};
  dvec3 up{0.0, 1.0, 0.0};
  double field_of_view_deg = 30.0;
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
