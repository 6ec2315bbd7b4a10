#include "core/image/relight.h"

#include "core/bands/band_shares.h"
#include "core/film/part_layers.h"
#include "core/image/metadata.h"
#include "spectral/observer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace abbe {

namespace {

/// The shares of bands that a plan gives a scene whose lights all have this spectrum.
BandShares shares_under(std::span<const Xyz> weights) {
  Xyz sum{0.0, 0.0, 0.0};
  for (const Xyz& weight : weights)
    sum += weight;
  std::vector<double> seen;
  for (const Xyz& w : weights)
    seen.push_back(std::hypot(w.x / sum.x, w.y / sum.y, w.z / sum.z));
  return BandShares(seen);
}

/// The relative variance of the luminance of one band that stands for all.
double variance_of_one(const BandShares& shares, std::span<const Xyz> weights) {
  double sum = 0.0, squares = 0.0;
  for (int b = 0; b < static_cast<int>(weights.size()); ++b) {
    const double y = weights[static_cast<std::size_t>(b)].y;
    sum += y;
    if (y > 0.0) squares += y * y / shares.of({b, b + 1});
  }
  return squares / (sum * sum) - 1.0;
}

} // namespace

double noise_of_change(const BandGrid& grid, const Curve& spectrum, Observer observer) {
  const std::vector<Xyz> now = band_weights(grid, spectrum, observer);
  const std::vector<Xyz> then = band_weights(grid, Curve::constant(1.0), observer);
  const auto lit = std::ranges::count_if(now, [](const Xyz& w) { return w.y > 0.0; });
  if (lit == 0) return 1.0;
  if (lit == 1) return std::numeric_limits<double>::infinity();
  return std::sqrt(variance_of_one(shares_under(then), now) /
                   variance_of_one(shares_under(now), now));
}

Lamp::Lamp(const BandGrid& grid, const Curve& spectrum, Observer observer)
    : weights_(band_weights(grid, spectrum, observer)) {}

Xyz Lamp::color(std::span<const float> unit) const {
  Xyz sum{0.0, 0.0, 0.0};
  for (std::size_t b = 0; b < weights_.size(); ++b)
    sum += weights_[b] * static_cast<double>(unit[b]);
  return sum;
}

SpectralImage develop_unit(const Film& film, const Plan& plan, const std::string& group,
                           const PixelWindow& rows) {
  const LayerId samples = film.find(unit_layer(group)).value();
  const std::optional<LayerId> splats = film.find(splats_of(unit_layer(group)));
  SpectralImage image{{0, 0, plan.settings.width, plan.settings.height},
                      rows,
                      {},
                      {},
                      {},
                      render_metadata(plan),
                      plan.camera};
  image.metadata.emplace_back("abbe/lightGroup", group);
  const auto bands = static_cast<std::size_t>(plan.grid.count());
  for (int b = 0; b < plan.grid.count(); ++b)
    image.wavelengths_nm.push_back(plan.grid.center_nm(b));
  const std::size_t pixels = rows.pixel_count();
  image.values.resize(pixels * bands);
  image.rgba.reserve(4 * pixels);
  const Lamp equal_energy(plan.grid, Curve::constant(1.0), plan.settings.observer);
  std::vector<float> unit(bands);
  std::size_t pixel = 0;
  for_each_pixel(rows, [&](int x, int y) {
    for (std::size_t b = 0; b < bands; ++b) {
      double value = film.mean(samples, x, y, b);
      if (splats && film.samples(x, y) > 0) value += film.mean(*splats, x, y, b);
      constexpr double kMost = std::numeric_limits<float>::max();
      unit[b] = static_cast<float>(std::min(value, kMost));
      image.values[b * pixels + pixel] = unit[b];
    }
    const LinearRgb c = to_linear_srgb(equal_energy.color(unit));
    for (const double v : {c.r, c.g, c.b, film.alpha(x, y)})
      image.rgba.push_back(static_cast<float>(v));
    ++pixel;
  });
  film.touched(pixels);
  return image;
}

} // namespace abbe
