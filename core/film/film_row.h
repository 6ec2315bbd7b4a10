#pragma once

#include "core/film/film.h"

#include <cstdint>
#include <vector>

namespace abbe {

/// What a layer holds of one row of pixels, pixel by pixel.
struct LayerRow {
  std::vector<std::int64_t> sums;
  std::vector<std::int64_t> first_sums;  ///< of the first stratum; empty without strata
  std::vector<std::vector<IdCount>> ids; ///< of the kind `ids`; else empty
};

/// All that a film holds of one row of pixels, as plain integers. A film whose rows are set from
/// those of another one with the same window and layers holds the same.
struct FilmRow {
  std::vector<std::uint32_t> counts, covered;
  std::vector<PixelStrata> strata; ///< empty where no layer has strata
  std::vector<LayerRow> layers;
};

/// Copies the row at the height y. The vectors of `row` are used again.
void get_row(const Film& film, int y, FilmRow& row);
/// Puts the row in the place of what the film holds there. The sizes of its vectors must be those
/// that `get_row` gives, and the film must hold no ids in that row yet. A layer whose vectors are
/// empty keeps what it holds.
void set_row(Film& film, int y, const FilmRow& row);

} // namespace abbe
