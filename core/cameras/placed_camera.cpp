#include "core/cameras/placed_camera.h"

namespace abbe {

PlacedCamera::PlacedCamera(const Scene& scene, const RenderSettings& settings, const World& world)
    : rays(scene.camera, settings.width, settings.height),
      nesting(world.nesting_at(scene.camera.eye)) {
  if (scene.camera.lens)
    lens.emplace(scene.camera, scene.mm_per_unit, settings.width, settings.height);
}

} // namespace abbe
