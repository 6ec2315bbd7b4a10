#include "core/image/relative_error.h"

#include "spectral/square.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace abbe {

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

double quantile(std::vector<double> values, double fraction) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

} // namespace abbe
