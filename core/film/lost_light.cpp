#include "core/film/lost_light.h"

#include <cmath>

namespace abbe {
namespace {

/// Luminances are up to 2^40 quanta as a rule, and more where a path stands for many; their squares
/// need as much room again.
double unit_of_squares(double quantum) {
  return quantum * 0x1p40;
}

/// A sum over pixels, and the variance of that sum.
struct Estimate {
  double sum = 0.0, variance = 0.0;
};

/// Paths that the limit ends are few, or followed by few, so the mean of squares is nearly their
/// variance, and never less.
void add(Estimate& estimate, const Film& film, LayerId id, int x, int y, double count) {
  if (!(count > 0.0)) return;
  estimate.sum += film.mean(id, x, y, 0);
  estimate.variance +=
      film.mean(id, x, y, 1) * unit_of_squares(film.layer(id).form().quantum) / count;
}

} // namespace

std::vector<LayerForm> lost_light_layers(double quantum, bool splats) {
  std::vector<LayerForm> layers{{kLost, LayerKind::xyz, quantum}};
  if (splats) layers.push_back({kLostSplats, LayerKind::xyz, quantum, 0, LayerMean::light_passes});
  return layers;
}

Xyz lost_light(double luminance, double quantum) {
  return {luminance, luminance * (luminance / unit_of_squares(quantum)), 0.0};
}

std::optional<LostShare> lost_share(const Film& film) {
  const auto lost = film.find(kLost), splats = film.find(kLostSplats);
  if (!lost) return std::nullopt;
  Estimate taken;
  double left = 0.0;
  for_each_pixel(film.window(), [&](int x, int y) {
    left += film.color(x, y).y;
    add(taken, film, *lost, x, y, film.samples(x, y));
    // A splat is a part of a pass's mean already.
    if (splats) add(taken, film, *splats, x, y, film.light_passes());
  });
  const double all = left + taken.sum;
  if (!(all > 0.0)) return std::nullopt;
  return LostShare{taken.sum / all, std::sqrt(taken.variance) * left / (all * all)};
}

} // namespace abbe
