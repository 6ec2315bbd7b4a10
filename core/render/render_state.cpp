#include "core/render/render_state.h"

#include "core/adaptive/sample_allocation.h"
#include "core/film/film_row.h"
#include "core/render/film_layers.h"

#include <utility>

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

RenderState copy_of(const RenderState& state, const BandPlace& place) {
  std::vector<LayerForm> forms;
  for (std::size_t l = 0; l < state.film.layer_count(); ++l)
    forms.push_back(state.film.layer(static_cast<LayerId>(l)).form());
  RenderState copy{.film = Film(state.film.window(), std::move(forms), place),
                   .done = state.done,
                   .tiles = state.tiles,
                   .rays = state.rays,
                   .seconds = state.seconds,
                   .light_seconds = state.light_seconds,
                   .light = state.light,
                   .planned = state.planned,
                   .round_end = state.round_end,
                   .shares = state.shares,
                   .allocation = state.allocation,
                   .pixel_rays = state.pixel_rays};
  FilmRow row;
  for (int y = state.film.window().y0; y < state.film.window().y1; ++y) {
    get_row(state.film, y, row);
    set_row(copy.film, y, row);
  }
  copy.film.add_light_passes(state.film.light_passes());
  copy.film.add_refused(state.film.refused());
  return copy;
}

void spread_samples(RenderState& state, std::vector<float> shares, int samples) {
  state.planned = true;
  state.shares = std::move(shares);
  state.allocation = allocate_samples(state.film, state.shares, samples);
}

} // namespace abbe
