#include "core/film/merge_films.h"

#include <fmt/format.h>

#include <stdexcept>

namespace abbe {
namespace {

/// Says in what two films do not fit together; empty where they do.
std::string misfit(const Film& a, const Film& b) {
  const auto text = [](const PixelWindow& w) {
    return fmt::format("{} {} {} {}", w.x0, w.y0, w.x1, w.y1);
  };
  if (a.window() != b.window())
    return fmt::format("one shows the pixels {}, the other {}", text(a.window()), text(b.window()));
  if (a.layer_count() != b.layer_count())
    return fmt::format("one has {} layers, the other {}", a.layer_count(), b.layer_count());
  for (std::size_t i = 0; i < a.layer_count(); ++i) {
    const LayerForm& f = a.layer(static_cast<LayerId>(i)).form();
    const LayerForm& g = b.layer(static_cast<LayerId>(i)).form();
    if (f.name != g.name)
      return fmt::format("one has a layer {} where the other has {}", f.name, g.name);
    if (f.quantum != g.quantum)
      return fmt::format("their layers {} count in steps of {} and {}", f.name, f.quantum,
                         g.quantum);
    if (!(f == g)) return fmt::format("their layers {} are not of one form", f.name);
  }
  return "";
}

} // namespace

void Film::merge_pixel(const Film& other, std::size_t pixel) {
  bool all_first = false;
  if (keeps_errors()) {
    const PixelStrata& theirs = other.strata_[pixel];
    raise_boundary(pixel, theirs.boundary);
    all_first = theirs.boundary < strata_[pixel].boundary;
    strata_[pixel].first += all_first ? other.counts_[pixel] : theirs.first;
  }
  for (std::size_t i = 0; i < layers_.size(); ++i)
    layers_[i].merge(other.layers_[i], pixel, all_first, refused_);
  counts_[pixel] += other.counts_[pixel];
  covered_[pixel] += other.covered_[pixel];
}

void merge(Film& film, const Film& other) {
  if (const std::string reason = misfit(film, other); !reason.empty())
    throw std::invalid_argument(fmt::format("these films cannot be merged: {}", reason));
  const auto width = static_cast<std::size_t>(film.window_.width());
  for (std::size_t pixel = 0; pixel < film.counts_.size(); ++pixel) {
    film.merge_pixel(other, pixel);
    if ((pixel + 1) % width != 0) continue;
    film.touched(width);
    other.touched(width);
  }
  film.light_passes_ += other.light_passes_;
  film.add_refused(other.refused_);
}

} // namespace abbe
