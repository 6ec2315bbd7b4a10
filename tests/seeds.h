#pragma once

#include "tests/render_text.h"

#include <cmath>
#include <vector>

namespace abbe::test {

/// Means of a picture's luminance over seeds, and their variances, per pixel and in all.
struct SeedStatistics {
  std::vector<double> mean, variance; ///< of each pixel's mean
  double total = 0.0;                 ///< the mean over all pixels
  double total_variance = 0.0;        ///< of `total`
};

/// Renders a scene with the seeds 1 to `seeds`.
inline SeedStatistics over_seeds(Scene scene, int seeds) {
  const auto pixels = static_cast<std::size_t>(scene.settings.width * scene.settings.height);
  std::vector<double> sum(pixels), squares(pixels);
  double total = 0.0, total_squares = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    scene.settings.seed = static_cast<std::uint64_t>(seed);
    const Rendering r = render_scene(scene, false);
    double all = 0.0;
    for (std::size_t i = 0; i < pixels; ++i) {
      const double y = r.film
                           .color(static_cast<int>(i) % scene.settings.width,
                                  static_cast<int>(i) / scene.settings.width)
                           .y;
      sum[i] += y;
      squares[i] += y * y;
      all += y / static_cast<double>(pixels);
    }
    total += all;
    total_squares += all * all;
  }
  const auto variance_of_mean = [&](double s, double s2) {
    return std::max(0.0, s2 / seeds - s / seeds * (s / seeds)) / (seeds - 1);
  };
  SeedStatistics result;
  for (std::size_t i = 0; i < pixels; ++i) {
    result.mean.push_back(sum[i] / seeds);
    result.variance.push_back(variance_of_mean(sum[i], squares[i]));
  }
  result.total = total / seeds;
  result.total_variance = variance_of_mean(total, total_squares);
  return result;
}

/// The mean over pixels of the squared difference in units of its standard deviation: 1 for equal
/// expectations and many seeds. Pixels without variance in both must be equal.
inline double mean_square_z(const SeedStatistics& a, const SeedStatistics& b) {
  double sum = 0.0;
  int counted = 0;
  for (std::size_t i = 0; i < a.mean.size(); ++i) {
    const double variance = a.variance[i] + b.variance[i];
    if (!(variance > 0.0)) continue;
    const double difference = a.mean[i] - b.mean[i];
    sum += difference * difference / variance;
    ++counted;
  }
  return counted > 0 ? sum / counted : 0.0;
}

/// The difference of the whole pictures' means in units of its standard deviation.
inline double total_z(const SeedStatistics& a, const SeedStatistics& b) {
  return (a.total - b.total) / std::sqrt(a.total_variance + b.total_variance);
}

} // namespace abbe::test
