#pragma once

#include "core/film/film.h"
#include "core/film/film_row.h"
#include "core/plan/plan.h"
#include "core/render/peers.h"
#include "core/render/render_state.h"

namespace abbe {

// What the states of peers are together. Camera samples of a pixel are all in the film of the peer
// that has its tile, and the splats of a pixel are in the films of all.

/// The row of all peers' films together, in the first peer. All peers call it for the same row.
void add_up_row(const Film& film, int y, const Peers& peers, FilmRow& row);

/// Makes the film of the first peer that of all peers together. Nothing may be rendered after it.
void add_up_film(Film& film, const Peers& peers);

/// The colours of camera samples in all peers' films together, in all peers: the layers of which
/// `find_shares` knows how noisy pixels are.
[[nodiscard]] Film add_up_colors(const Film& film, const Peers& peers);

/// Gives the first peer what all have counted: rays, those of each pixel, and refused values.
void add_up_counts(RenderState& state, const Peers& peers);

/// Leaves in a row of the picture what belongs to this peer: the pixels of its tiles, and in the
/// first peer all splats.
void keep_own(FilmRow& row, int y, const Plan& plan, const std::vector<LayerForm>& layers,
              const Peers& peers);

/// Puts in the place of the splats' colours in each peer's film those of all peers together.
void share_splats(Film& film, const Peers& peers);
/// Takes that back: only the first peer keeps them.
void part_with_splats(Film& film, const Peers& peers);

} // namespace abbe
