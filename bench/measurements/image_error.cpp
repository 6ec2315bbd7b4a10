#include "bench/measurements/image_error.h"

#include "spectral/color_difference.h"
#include "spectral/square.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace abbe::bench {

double relative_mse(const std::vector<LinearRgb>& image, const std::vector<LinearRgb>& reference) {
  assert(image.size() == reference.size() && !reference.empty());
  const double values = 3.0 * static_cast<double>(reference.size());
  double mean = 0.0;
  for (const LinearRgb& r : reference)
    mean += (r.r + r.g + r.b) / values;
  const double floor = 0.01 * square(mean);
  double sum = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const LinearRgb &x = image[i], &r = reference[i];
    sum += square(x.r - r.r) / (square(r.r) + floor) + square(x.g - r.g) / (square(r.g) + floor) +
           square(x.b - r.b) / (square(r.b) + floor);
  }
  return sum / values;
}

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

double quantile(std::vector<double> values, double fraction) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

} // namespace abbe::bench
