#include "core/adaptive/noise.h"

#include "spectral/square.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abbe {

double relative_error(const Film& film, const PixelWindow& part) {
  const double values = 3.0 * static_cast<double>(part.pixel_count());
  double mean = 0.0;
  for_each_pixel(part, [&](int x, int y) {
    const Xyz r = film.color(x, y);
    mean += (r.x + r.y + r.z) / values;
  });
  const double floor = 0.01 * square(mean);
  double sum = 0.0;
  const auto add = [&](double e, double r) {
    if (e > 0.0) sum += square(e) / (square(r) + floor); // e > 0 makes r and the mean positive
  };
  for_each_pixel(part, [&](int x, int y) {
    const Xyz r = film.color(x, y), e = film.error(x, y);
    add(e.x, r.x);
    add(e.y, r.y);
    add(e.z, r.z);
  });
  return std::sqrt(sum / values);
}

SampleCounts sample_counts(const Film& film) {
  SampleCounts counts{std::numeric_limits<std::uint32_t>::max(), 0, 0.0};
  for_each_pixel(film.window(), [&](int x, int y) {
    const std::uint32_t n = film.samples(x, y);
    counts.least = std::min(counts.least, n);
    counts.most = std::max(counts.most, n);
    counts.mean += n;
  });
  counts.mean /= static_cast<double>(film.window().pixel_count());
  return counts;
}

} // namespace abbe
