#include "io/states/merge_states.h"

#include "core/film/film_row.h"
#include "core/film/merge_films.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace abbe {

RenderState merge_states(std::span<StateReader> parts, const BandPlace& place) {
  assert(!parts.empty());
  const PixelWindow window = parts.front().window();
  const std::vector<LayerForm> layers = parts.front().layers();
  const bool ids = std::ranges::any_of(
      layers, [](const LayerForm& form) { return form.kind == LayerKind::ids; });
  // Films of one row, for what films know of adding: strata, nearest values, sums that overflow.
  const auto one_row = [&] {
    return Film({window.x0, window.y0, window.x1, window.y0 + 1}, layers);
  };
  Film all(window, layers, place), sum = one_row(), next = one_row();
  FilmRow row;
  for (int y = window.y0; y < window.y1; ++y) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Film& film = i == 0 ? sum : next;
      if (ids) { // are added to those that are there, and not put in their place
        const RefusedValues refused = film.refused();
        film = one_row();
        film.add_refused(refused);
      }
      parts[i].read_row(row);
      set_row(film, window.y0, row);
      if (i > 0) merge(sum, next);
    }
    get_row(sum, window.y0, row);
    set_row(all, y, row);
  }
  RenderState state = parts.front().end_rows();
  all.add_light_passes(state.film.light_passes());
  all.add_refused(state.film.refused());
  all.add_refused(sum.refused());
  for (StateReader& part : parts.subspan(1)) {
    const RenderState other = part.end_rows();
    all.add_light_passes(other.film.light_passes());
    all.add_refused(other.film.refused());
    state.rays += other.rays;
    state.seconds += other.seconds;
    state.light_seconds += other.light_seconds;
  }
  state.film = std::move(all);
  return state;
}

} // namespace abbe
