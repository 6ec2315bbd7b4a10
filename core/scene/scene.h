#pragma once

#include "core/scene/camera.h"
#include "core/scene/display_settings.h"
#include "core/scene/environment.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/scene/settings.h"
#include "geometry/world/shape.h"
#include "spectral/curve.h"

#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// A scene as plain values. Nothing is looked up by name after reading.
struct Scene {
  std::string title; ///< the name of the file without folder and extension
  Camera camera;
  RenderSettings settings;
  DisplaySettings display;
  double mm_per_unit = 1.0; ///< length of one scene unit

  std::vector<PlacedShape> shapes;
  std::vector<std::string> object_names; ///< by ShapeId; "" where a shape has none
  std::vector<Material> materials;       ///< by MaterialId
  std::vector<Medium> media;             ///< by MediumId
  std::vector<Light> lights;
  std::vector<ReflectanceImage> images; ///< of textures

  Curve background = Curve::constant(0.0);     ///< the radiance of a ray that meets nothing
  std::optional<Environment> environment;      ///< adds radiance by direction to the background
  Curve global_ambient = Curve::constant(0.0); ///< the thesis's stand-in for indirect light
};

} // namespace abbe
