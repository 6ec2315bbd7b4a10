#include "bench/measurements/image_error.h"

#include "spectral/color_difference.h"
#include "spectral/square.h"

#include <cassert>
#include <cmath>

namespace abbe::bench {

ImageError image_error(const std::vector<Xyz>& image, const std::vector<Xyz>& reference) {
  assert(image.size() == reference.size() && !reference.empty());
  const Xyz white = to_xyz(kSrgbWhite, 1.0);
  std::vector<LinearRgb> rgb, reference_rgb;
  std::vector<double> differences;
  double squares = 0.0, difference_sum = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const Xyz &x = image[i], &r = reference[i];
    rgb.push_back(to_linear_srgb(x));
    reference_rgb.push_back(to_linear_srgb(r));
    squares += square(x.x - r.x) + square(x.y - r.y) + square(x.z - r.z);
    differences.push_back(delta_e_2000(to_lab(x, white), to_lab(r, white)));
    difference_sum += differences.back();
  }
  const auto count = static_cast<double>(reference.size());
  return {relative_mse(rgb, reference_rgb), std::sqrt(squares / (3.0 * count)),
          difference_sum / count, quantile(std::move(differences), 0.95), std::nullopt};
}

double band_noise(const Film& image, const Film& reference) {
  const PixelWindow& w = reference.window();
  double sum = 0.0;
  int counted = 0;
  for (int band = 0; band < reference.bands(); ++band) {
    double squares = 0.0, differences = 0.0;
    for (int y = w.y0; y < w.y1; ++y)
      for (int x = w.x0; x < w.x1; ++x) {
        const double r = reference.radiance(x, y, band);
        squares += square(r);
        differences += square(image.radiance(x, y, band) - r);
      }
    if (!(squares > 0.0)) continue;
    sum += differences / squares;
    ++counted;
  }
  return counted > 0 ? sum / counted : 0.0;
}

std::size_t changed_pixels(const Film& a, const Film& b) {
  const auto differ = [&](int x, int y) {
    if (a.color(x, y) != b.color(x, y) || a.alpha(x, y) != b.alpha(x, y) ||
        a.covered_samples(x, y) != b.covered_samples(x, y))
      return true;
    for (int band = 0; band < a.bands(); ++band)
      if (a.radiance(x, y, band) != b.radiance(x, y, band)) return true;
    return false;
  };
  const PixelWindow& w = a.window();
  std::size_t changed = 0;
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.x0; x < w.x1; ++x)
      changed += differ(x, y) ? 1 : 0;
  return changed;
}

std::vector<Xyz> pixels(const Film& film) {
  std::vector<Xyz> colors;
  const PixelWindow& w = film.window();
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.x0; x < w.x1; ++x)
      colors.push_back(film.color(x, y));
  return colors;
}

} // namespace abbe::bench
