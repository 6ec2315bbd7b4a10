#pragma once

#include "core/cameras/camera.h"
#include "core/cameras/lens_camera.h"
#include "core/scene/settings.h"
#include "geometry/world.h"

#include <optional>

namespace abbe {

/// A scene's camera: the rays of a pinhole or a thin lens, or those of a real lens where there is
/// one.
struct PlacedCamera {
  CameraRays rays;
  std::optional<LensCamera> lens;
  Nesting nesting; ///< the solids around the eye

  PlacedCamera(const Scene& scene, const RenderSettings& settings, const World& world);

  [[nodiscard]] double pixel_angle() const {
    return lens ? lens->pixel_angle() : rays.pixel_angle();
  }
  /// True where each place of the scene has one place in the picture.
  [[nodiscard]] bool pinhole() const { return !lens && !rays.has_aperture(); }
};

} // namespace abbe
