#pragma once

#include "core/cameras/lens_camera.h"
#include "core/cameras/pinhole_camera.h"
#include "core/cameras/thin_lens_camera.h"
#include "core/scene/scene.h"
#include "geometry/world/world.h"

#include <optional>
#include <variant>

namespace abbe {

// What is asked of a camera, whatever its kind. Each question is one visit without a default, so
// each kind answers all of them, by functions of the same name beside its class and by members of
// its class. The compiler lists what a new kind lacks in placed_camera.cpp, and in
// core/render/camera_start.cpp how its samples start: along one ray for all bands, by a member
// `ray`, or as LensFan parts them.

/// Cameras that are ready for an image of a given size, one class for each CameraKind.
using ReadyCamera = std::variant<PinholeCamera, ThinLensCamera, LensCamera>;

/// A scene's camera, placed among its shapes.
struct PlacedCamera {
  ReadyCamera camera;
  Nesting nesting; ///< the solids around the eye

  PlacedCamera(const Scene& scene, const RenderSettings& settings, const World& world);

  /// Width of a pixel in the middle of the image as seen from the eye, in radians.
  [[nodiscard]] double pixel_angle() const;
  /// True when light paths can be connected with the camera: `connect` answers then.
  [[nodiscard]] bool connects() const;
  /// Connects a point of the scene with the camera. Nothing where it does not see the point, or
  /// cannot be connected with.
  [[nodiscard]] std::optional<CameraConnection> connect(const dvec3& point) const;
};

/// Where the scene's points appear in an image of this size; empty where the camera has no such
/// map.
[[nodiscard]] Projection projection(const Scene& scene, int width, int height);

/// True when light paths can be connected with cameras of this kind.
[[nodiscard]] bool connects(const CameraKind& kind);

/// How far from the eye camera rays may begin, in scene units.
[[nodiscard]] double camera_reach(const Scene& scene);

} // namespace abbe
