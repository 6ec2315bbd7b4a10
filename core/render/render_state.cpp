#include "core/render/render_state.h"

#include "core/cameras/placed_camera.h"

namespace abbe {

RenderState begin_rendering(const Scene& scene, const Plan& plan,
                            const std::optional<BandPlace>& bands) {
  const BeautyForm beauty{.quantum = plan.quantum,
                          .bands = bands ? plan.grid.count() : 0,
                          .errors = plan.settings.needs_errors(),
                          .splats = plan.caustics && connects(scene.camera.kind),
                          .evidence =
                              plan.caustics && plan.settings.adaptive == AdaptiveSampling::on};
  RenderState state{
      .film = Film(plan.window, beauty_layers(beauty), bands.value_or(BandPlace{})),
      .tiles = std::vector<TileState>(plan.tiles.size()),
  };
  if (plan.settings.adaptive == AdaptiveSampling::on)
    state.pixel_rays.resize(plan.window.pixel_count());
  return state;
}

} // namespace abbe
