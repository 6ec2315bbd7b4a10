#include "tests/stress/moved_scene.h"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace abbe::stress {
namespace {

/// Those of `light` that has a place; null for one that is in the sky.
template <class Kind>
dvec3* place_of(Kind& kind) {
  if constexpr (requires { kind.position; })
    return &kind.position;
  else
    return nullptr;
}

void scale_camera(CameraKind& kind, double scale) {
  std::visit(
      [&]<class K>(K& camera) {
        if constexpr (!std::is_same_v<K, Pinhole>) {
          camera.aperture *= scale;
          if (camera.focus_distance) *camera.focus_distance *= scale;
        }
      },
      kind);
}

} // namespace

double size_of(const Scene& scene) {
  Bounds box{scene.camera.eye, scene.camera.eye};
  for (const PlacedShape& shape : scene.shapes)
    if (is_bounded(shape.shape)) box = box.joined(bounds(shape));
  for (Light light : scene.lights) {
    const dvec3* place = std::visit([](auto& kind) { return place_of(kind); }, light.kind);
    if (place) box = box.joined({*place, *place});
  }
  const dvec3 extent = box.upper - box.lower;
  return std::max({extent.x, extent.y, extent.z});
}

Scene moved_scene(Scene scene, double scale, const dvec3& offset) {
  const auto moved = [&](const dvec3& place) { return offset + scale * place; };
  const Transform map(glm::dmat3(scale), offset);
  for (PlacedShape& shape : scene.shapes)
    shape.to_world = map.after(shape.to_world);
  for (Light& light : scene.lights)
    std::visit(
        [&](auto& kind) {
          if (dvec3* place = place_of(kind)) *place = moved(*place);
          if constexpr (requires { kind.falloff; })
            if (kind.falloff == Falloff::square)
              light.spectrum = light.spectrum.scaled(scale * scale);
        },
        light.kind);
  scene.camera.eye = moved(scene.camera.eye);
  scene.camera.look_at = moved(scene.camera.look_at);
  scale_camera(scene.camera.kind, scale);
  scene.settings.photon_radius *= scale;
  scene.mm_per_unit /= scale;
  return scene;
}

} // namespace abbe::stress
