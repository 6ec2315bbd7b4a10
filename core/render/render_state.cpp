#include "core/render/render_state.h"

#include "core/cameras/placed_camera.h"
#include "core/film/lost_light.h"

#include <utility>

namespace abbe {

RenderState begin_rendering(const Scene& scene, const Plan& plan,
                            const std::optional<BandPlace>& bands) {
  const BeautyForm beauty{.quantum = plan.quantum,
                          .bands = bands ? plan.grid.count() : 0,
                          .errors = plan.settings.needs_errors(),
                          .splats = plan.caustics && connects(scene.camera.kind)};
  std::vector<LayerForm> layers = beauty_layers(beauty);
  if (plan.settings.max_depth < kNoDepthLimit)
    for (LayerForm& layer : lost_light_layers(plan.quantum, beauty.splats))
      layers.push_back(std::move(layer));
  RenderState state{
      .film = Film(plan.window, std::move(layers), bands.value_or(BandPlace{})),
      .tiles = std::vector<TileState>(plan.tiles.size()),
  };
  if (plan.settings.adaptive == AdaptiveSampling::on)
    state.pixel_rays.resize(plan.window.pixel_count());
  return state;
}

} // namespace abbe
