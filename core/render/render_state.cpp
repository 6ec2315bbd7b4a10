#include "core/render/render_state.h"

#include "core/render/film_layers.h"

namespace abbe {

RenderState begin_rendering(const Scene& scene, const Plan& plan,
                            const std::optional<BandPlace>& bands, const RenderPart& part) {
  RenderState state{
      .film = Film(plan.window, film_layers(scene, plan, bands), bands.value_or(BandPlace{})),
      .tiles = std::vector<TileState>(plan.tiles.size()),
  };
  state.light.part = part;
  if (plan.settings.adaptive == AdaptiveSampling::on)
    state.pixel_rays.resize(plan.window.pixel_count());
  return state;
}

} // namespace abbe
