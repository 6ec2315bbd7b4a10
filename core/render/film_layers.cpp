#include "core/render/film_layers.h"

#include "core/cameras/placed_camera.h"
#include "core/film/lost_light.h"
#include "core/film/part_layers.h"
#include "core/render/first_hit.h"

#include <utility>

namespace abbe {

std::vector<LayerForm> film_layers(const Scene& scene, const Plan& plan,
                                   const std::optional<BandPlace>& bands) {
  const bool splats = plan.caustics && connects(scene.camera.kind);
  std::vector<LayerForm> layers =
      beauty_layers({.quantum = plan.quantum,
                     .bands = bands && bands->spectra ? plan.grid.count() : 0,
                     .errors = plan.settings.needs_errors(),
                     .splats = splats,
                     .halves = plan.settings.layers.tells_noise(),
                     .evidence = plan.caustics && plan.settings.adaptive == AdaptiveSampling::on});
  if (plan.sky.lets_through) layers.push_back(transparency_layer());
  if (plan.sky.tints) layers.push_back(transmittance_layer());
  if (plan.settings.max_depth < kNoDepthLimit)
    for (LayerForm& layer : lost_light_layers(plan.quantum, splats))
      layers.push_back(std::move(layer));
  for (auto&& more : {part_layers(plan, splats), first_hit_layers(scene, plan)})
    layers.insert(layers.end(), more.begin(), more.end());
  return layers;
}

} // namespace abbe
