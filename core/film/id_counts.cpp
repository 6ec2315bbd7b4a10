#include "core/film/id_counts.h"

#include <algorithm>

namespace abbe {

void IdCounts::add(std::size_t pixel, std::uint32_t id, std::uint32_t count) {
  Pixel& p = pixels_[pixel];
  if (p.first.count == 0) p.first.id = id;
  if (p.first.id == id) {
    p.first.count += count;
    return;
  }
  if (!p.more) p.more = std::make_unique<std::vector<IdCount>>();
  const auto known = std::ranges::find(*p.more, id, &IdCount::id);
  if (known != p.more->end())
    known->count += count;
  else
    p.more->push_back({id, count});
}

std::vector<IdCount> IdCounts::of(std::size_t pixel) const {
  const Pixel& p = pixels_[pixel];
  std::vector<IdCount> pairs;
  if (p.first.count > 0) pairs.push_back(p.first);
  if (p.more) pairs.insert(pairs.end(), p.more->begin(), p.more->end());
  std::ranges::sort(pairs, [](const IdCount& a, const IdCount& b) {
    return a.count != b.count ? a.count > b.count : a.id < b.id;
  });
  return pairs;
}

} // namespace abbe
