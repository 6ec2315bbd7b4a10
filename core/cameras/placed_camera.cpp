#include "core/cameras/placed_camera.h"

#include <utility>
#include <variant>

namespace abbe {
namespace {

ReadyCamera ready_camera(const Scene& scene, const ImageScale& image) {
  return std::visit(
      [&](const auto& kind) -> ReadyCamera { return place(kind, scene.camera, image); },
      scene.camera.kind);
}

} // namespace

PlacedCamera::PlacedCamera(const Scene& scene, const RenderSettings& settings, const World& world)
    : camera(ready_camera(scene, {settings.width, settings.height, scene.mm_per_unit})),
      nesting(world.nesting_at(scene.camera.eye)) {}

double PlacedCamera::pixel_angle() const {
  return std::visit([](const auto& ready) { return ready.pixel_angle(); }, camera);
}

bool PlacedCamera::connects() const {
  return std::visit([]<class C>(const C&) { return C::kConnects; }, camera);
}

std::optional<CameraConnection> PlacedCamera::connect(const dvec3& point) const {
  return std::visit([&](const auto& ready) { return ready.connect(point); }, camera);
}

Projection projection(const Scene& scene, int width, int height) {
  const ImageScale image{width, height, scene.mm_per_unit};
  return std::visit([&](const auto& kind) { return projection(kind, scene.camera, image); },
                    scene.camera.kind);
}

bool connects(const CameraKind& kind) {
  return std::visit(
      []<class Kind>(const Kind&) {
        using Ready = decltype(place(std::declval<const Kind&>(), std::declval<const Camera&>(),
                                     std::declval<const ImageScale&>()));
        return Ready::kConnects;
      },
      kind);
}

double camera_reach(const Scene& scene) {
  return std::visit([&](const auto& kind) { return reach(kind, scene.mm_per_unit); },
                    scene.camera.kind);
}

} // namespace abbe
