#include "core/render/peer_sums.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace abbe {
namespace {

/// Calls `use` with each number of a row, but for ids. It may change them.
template <class Use>
void for_each_number(FilmRow& row, const Use& use) {
  for (std::uint32_t& n : row.counts)
    use(n);
  for (std::uint32_t& n : row.covered)
    use(n);
  for (PixelStrata& strata : row.strata) {
    use(strata.boundary);
    use(strata.first);
  }
  for (LayerRow& layer : row.layers) {
    for (std::int64_t& sum : layer.sums)
      use(sum);
    for (std::int64_t& sum : layer.first_sums)
      use(sum);
  }
}

std::vector<std::int64_t> numbers_of(FilmRow& row) {
  std::vector<std::int64_t> numbers;
  for_each_number(row, [&](auto& n) { numbers.push_back(n); });
  return numbers;
}

void set_numbers(FilmRow& row, const std::vector<std::int64_t>& numbers) {
  auto next = numbers.begin();
  for_each_number(row, [&](auto& n) { n = static_cast<std::decay_t<decltype(n)>>(*next++); });
}

/// The ids of a row, as place and pair, of all peers. No two peers have samples of one pixel.
void collect_ids(FilmRow& row, const Peers& peers) {
  for (LayerRow& layer : row.layers) {
    if (layer.ids.empty()) continue;
    std::vector<std::int64_t> list;
    for (std::size_t i = 0; i < layer.ids.size(); ++i)
      for (const IdCount& pair : layer.ids[i])
        list.insert(list.end(), {static_cast<std::int64_t>(i), pair.id, pair.count});
    const std::vector<std::int64_t> all = peers.collect_in_first(list);
    for (std::vector<IdCount>& ids : layer.ids)
      ids.clear();
    for (std::size_t i = 0; i + 2 < all.size(); i += 3)
      layer.ids[static_cast<std::size_t>(all[i])].push_back(
          {static_cast<std::uint32_t>(all[i + 1]), static_cast<std::uint32_t>(all[i + 2])});
  }
}

void clear(LayerRow& layer) {
  layer.sums.clear();
  layer.first_sums.clear();
  layer.ids.clear();
}

/// Changes the colours of splats, row by row.
template <class Change>
void change_splats(Film& film, const Change& change) {
  const std::optional<LayerId> splats = film.find(kSplats);
  if (!splats) return;
  FilmRow row;
  for (int y = film.window().y0; y < film.window().y1; ++y) {
    get_row(film, y, row);
    for (std::size_t l = 0; l < row.layers.size(); ++l)
      if (l != static_cast<std::size_t>(*splats)) clear(row.layers[l]); // stays as it is
    change(row.layers[static_cast<std::size_t>(*splats)].sums);
    set_row(film, y, row);
  }
}

} // namespace

void add_up_row(const Film& film, int y, const Peers& peers, FilmRow& row) {
  get_row(film, y, row);
  if (peers.alone()) return;
  std::vector<std::int64_t> numbers = numbers_of(row);
  peers.add_up_in_first(numbers);
  if (peers.is_first()) set_numbers(row, numbers);
  collect_ids(row, peers);
}

void add_up_film(Film& film, const Peers& peers) {
  if (peers.alone()) return;
  FilmRow row;
  for (int y = film.window().y0; y < film.window().y1; ++y) {
    get_row(film, y, row);
    std::vector<std::int64_t> numbers = numbers_of(row);
    peers.add_up_in_first(numbers);
    set_numbers(row, numbers);
    if (peers.is_first()) // its own are in the film already, to which others are added
      for (LayerRow& layer : row.layers)
        for (std::vector<IdCount>& ids : layer.ids)
          ids.clear();
    collect_ids(row, peers);
    if (peers.is_first()) set_row(film, y, row);
  }
}

Film add_up_colors(const Film& film, const Peers& peers) {
  std::vector<std::size_t> from;
  std::vector<LayerForm> forms;
  for (const char* name : {kBeauty, kEvidence})
    if (const std::optional<LayerId> id = film.find(name)) {
      from.push_back(static_cast<std::size_t>(*id));
      forms.push_back(film.layer(*id).form());
    }
  Film sum(film.window(), std::move(forms));
  FilmRow all, row;
  for (int y = film.window().y0; y < film.window().y1; ++y) {
    get_row(film, y, all);
    row.counts = all.counts;
    row.covered = all.covered;
    row.strata = all.strata;
    row.layers.clear();
    for (const std::size_t l : from)
      row.layers.push_back(all.layers[l]);
    std::vector<std::int64_t> numbers = numbers_of(row);
    peers.add_up(numbers);
    set_numbers(row, numbers);
    set_row(sum, y, row);
  }
  return sum;
}

void add_up_counts(RenderState& state, const Peers& peers) {
  RayCounts& rays = state.rays;
  const RefusedValues own = state.film.refused();
  RefusedValues refused = own;
  const auto counts = {&rays.camera,     &rays.reflected,     &rays.refracted,   &rays.scattered,
                       &rays.shadow,     &rays.light,         &rays.splats,      &rays.photons,
                       &rays.not_finite, &refused.not_finite, &refused.negative, &refused.overflow};
  std::vector<std::int64_t> numbers;
  for (const std::uint64_t* count : counts)
    numbers.push_back(static_cast<std::int64_t>(*count));
  numbers.insert(numbers.end(), state.pixel_rays.begin(), state.pixel_rays.end());
  peers.add_up_in_first(numbers);
  if (!peers.is_first()) std::ranges::fill(numbers, 0);
  auto next = numbers.begin();
  for (std::uint64_t* count : counts)
    *count = static_cast<std::uint64_t>(*next++);
  for (std::uint32_t& count : state.pixel_rays)
    count = static_cast<std::uint32_t>(*next++);
  // Counts wrap around, so that what others have handed over is gone from theirs.
  state.film.add_refused({refused.not_finite - own.not_finite, refused.negative - own.negative,
                          refused.overflow - own.overflow});
}

void keep_own(FilmRow& row, int y, const Plan& plan, const std::vector<LayerForm>& layers,
              const Peers& peers) {
  std::vector<bool> own(row.counts.size());
  for (std::size_t t = 0; t < plan.tiles.size(); ++t) {
    const PixelWindow& tile = plan.tiles[t].window;
    if (!peers.has_tile(t) || y < tile.y0 || y >= tile.y1) continue;
    for (int x = tile.x0; x < tile.x1; ++x)
      own[static_cast<std::size_t>(x - plan.window.x0)] = true;
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i]) continue;
    row.counts[i] = row.covered[i] = 0;
    if (!row.strata.empty()) row.strata[i] = {};
  }
  for (std::size_t l = 0; l < layers.size(); ++l) {
    LayerRow& layer = row.layers[l];
    const std::size_t values = layers[l].values();
    const bool splats = layers[l].mean == LayerMean::light_passes;
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (splats ? peers.is_first() : own[i]) continue;
      const auto at = static_cast<std::ptrdiff_t>(i * values);
      std::fill_n(layer.sums.begin() + at, values, 0);
      if (!layer.first_sums.empty()) std::fill_n(layer.first_sums.begin() + at, values, 0);
      if (!layer.ids.empty()) layer.ids[i].clear();
    }
  }
}

void share_splats(Film& film, const Peers& peers) {
  change_splats(film, [&](std::vector<std::int64_t>& sums) { peers.add_up(sums); });
}

void part_with_splats(Film& film, const Peers& peers) {
  if (peers.is_first()) return;
  change_splats(film, [](std::vector<std::int64_t>& sums) { std::ranges::fill(sums, 0); });
}

} // namespace abbe
