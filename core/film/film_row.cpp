#include "core/film/film_row.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace abbe {

void get_row(const Film& film, int y, FilmRow& row) {
  const PixelWindow& window = film.window();
  const auto width = static_cast<std::size_t>(window.width());
  const std::size_t begin = window.index(window.x0, y);
  row.counts.resize(width);
  row.covered.resize(width);
  row.strata.resize(film.keeps_errors() ? width : 0);
  row.layers.resize(film.layer_count());
  for (std::size_t i = 0; i < width; ++i) {
    const int x = window.x0 + static_cast<int>(i);
    row.counts[i] = film.samples(x, y);
    row.covered[i] = film.covered_samples(x, y);
    if (!row.strata.empty()) row.strata[i] = film.strata(x, y);
  }
  for (std::size_t l = 0; l < row.layers.size(); ++l)
    film.layer(static_cast<LayerId>(l)).get(begin, width, row.layers[l]);
  film.touched(width);
}

void set_row(Film& film, int y, const FilmRow& row) {
  const auto width = static_cast<std::size_t>(film.window_.width());
  const std::size_t begin = film.window_.index(film.window_.x0, y);
  assert(row.counts.size() == width && row.covered.size() == width);
  assert(row.strata.size() == (film.keeps_errors() ? width : 0));
  assert(row.layers.size() == film.layers_.size());
  const auto at = static_cast<std::ptrdiff_t>(begin);
  std::ranges::copy(row.counts, film.counts_.begin() + at);
  std::ranges::copy(row.covered, film.covered_.begin() + at);
  if (film.keeps_errors()) std::ranges::copy(row.strata, film.strata_.begin() + at);
  for (std::size_t l = 0; l < row.layers.size(); ++l)
    film.layers_[l].set(begin, row.layers[l]);
  film.touched(width);
}

void Layer::get(std::size_t pixel, std::size_t count, LayerRow& row) const {
  const std::size_t begin = pixel * values_, size = count * values_;
  row.sums.resize(size);
  row.first_sums.resize(form_.strata ? size : 0);
  for (std::size_t i = 0; i < size; ++i)
    row.sums[i] = sums_[begin + i];
  for (std::size_t i = 0; i < row.first_sums.size(); ++i)
    row.first_sums[i] = first_sums_[begin + i];
  row.ids.resize(form_.kind == LayerKind::ids ? count : 0);
  for (std::size_t i = 0; i < row.ids.size(); ++i)
    row.ids[i] = ids_.of(pixel + i);
}

void Layer::set(std::size_t pixel, const LayerRow& row) {
  const std::size_t begin = pixel * values_;
  assert(row.first_sums.size() == (form_.strata ? row.sums.size() : 0));
  for (std::size_t i = 0; i < row.sums.size(); ++i)
    sums_[begin + i] = row.sums[i];
  for (std::size_t i = 0; i < row.first_sums.size(); ++i)
    first_sums_[begin + i] = row.first_sums[i];
  for (std::size_t i = 0; i < row.ids.size(); ++i)
    for (const IdCount& pair : row.ids[i])
      ids_.add(pixel + i, pair.id, pair.count);
}

} // namespace abbe
