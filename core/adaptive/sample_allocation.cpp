#include "core/adaptive/sample_allocation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>

namespace abbe {
namespace {

/// Values of a film's pixels, row by row.
struct Map {
  int width, height;
  std::vector<float> values =
      std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

  [[nodiscard]] float* row(int y) {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
  [[nodiscard]] const float* row(int y) const {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
};

template <class Use>
void for_each_row(int rows, const Use& use) {
  tbb::parallel_for(0, rows, [&](int y) { use(y); });
}

/// The sum over rows of a row's sum, always in the same order.
template <class SumOfRow>
double sum_of_rows(int rows, const SumOfRow& sum_of_row) {
  std::vector<double> sums(static_cast<std::size_t>(rows));
  for_each_row(rows, [&](int y) { sums[static_cast<std::size_t>(y)] = sum_of_row(y); });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double square(double v) {
  return v * v;
}

std::array<double, 3> rgb(const Xyz& color) {
  const LinearRgb c = to_linear_srgb(color);
  return {c.r, c.g, c.b};
}

/// The relative variance of one sample of each pixel. 0 everywhere for a black picture.
Map sample_variances(const Film& film) {
  const PixelWindow& w = film.window();
  Map map{w.width(), w.height()};
  const double mean = sum_of_rows(map.height,
                                  [&](int y) {
                                    double sum = 0.0;
                                    for (int x = w.x0; x < w.x1; ++x)
                                      for (const double v : rgb(film.color(x, w.y0 + y)))
                                        sum += v;
                                    return sum;
                                  }) /
                      (3.0 * static_cast<double>(w.pixel_count()));
  if (!(mean > 0.0)) return map;
  const double floor = 0.01 * square(mean);
  for_each_row(map.height, [&](int y) {
    float* const row = map.row(y);
    for (int x = 0; x < map.width; ++x) {
      const int px = w.x0 + x, py = w.y0 + y;
      const auto r = rgb(film.color(px, py)), e = rgb(film.signed_error(px, py));
      double sum = 0.0;
      for (std::size_t i = 0; i < 3; ++i)
        sum += square(e[i]) / (square(r[i]) + floor);
      row[x] = static_cast<float>(sum / 3.0 * film.samples(px, py));
    }
  });
  return map;
}

constexpr int kTentRadius = 2; ///< 5 x 5 pixels; measured: docs/decisions/noise.md

/// The mean over pixels up to kTentRadius away in one direction, weighed by a tent: of
/// `at(first ... last - 1)` around `i`.
template <class At>
float tent_mean(int i, int count, const At& at) {
  float sum = 0.0f, weights = 0.0f;
  for (int k = std::max(i - kTentRadius, 0); k <= std::min(i + kTentRadius, count - 1); ++k) {
    const auto weight = static_cast<float>(kTentRadius + 1 - std::abs(k - i));
    sum += weight * at(k);
    weights += weight;
  }
  return sum / weights;
}

Map smoothed(const Map& map) {
  Map across = map, result = map;
  for_each_row(map.height, [&](int y) {
    for (int x = 0; x < map.width; ++x)
      across.row(y)[x] = tent_mean(x, map.width, [&](int k) { return map.row(y)[k]; });
  });
  for_each_row(map.height, [&](int y) {
    for (int x = 0; x < map.width; ++x)
      result.row(y)[x] = tent_mean(y, map.height, [&](int k) { return across.row(k)[x]; });
  });
  return result;
}

/// Equal shares would take the step from one number of samples to the next all at once, and the
/// mean number of samples would miss what is wanted. So shares differ a little from pixel to pixel,
/// by Roberts's evenly spread sequence along the lattice of pixels [Roberts18].
double dither(int x, int y) {
  constexpr double kPart = 0.1; // costs less than 1 % of the gain; measured
  const double u = x * 0.7548776662466927 + y * 0.5698402909980532;
  return 1.0 + kPart * (2.0 * (u - std::floor(u)) - 1.0);
}

/// What a sample of each pixel costs: its rays, and one more for all that is done without any.
Map sample_costs(const Film& film, std::span<const std::uint32_t> rays) {
  const PixelWindow& w = film.window();
  Map map{w.width(), w.height()};
  for_each_row(map.height, [&](int y) {
    const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width);
    for (int x = 0; x < map.width; ++x)
      map.row(y)[x] = 1.0f + static_cast<float>(rays[first + static_cast<std::size_t>(x)]) /
                                 static_cast<float>(film.samples(w.x0 + x, w.y0 + y));
  });
  return map;
}

/// Shares in proportion to which pixels get samples; nothing where no pixel has any noise.
std::optional<Map> find_shares(const Film& film, std::span<const std::uint32_t> rays) {
  Map shares = smoothed(sample_variances(film));
  const Map costs = smoothed(sample_costs(film, rays));
  const double mean = sum_of_rows(shares.height,
                                  [&](int y) {
                                    float* const row = shares.row(y);
                                    const float* const cost = costs.row(y);
                                    double sum = 0.0;
                                    for (int x = 0; x < shares.width; ++x)
                                      sum += row[x] = std::sqrt(row[x] / cost[x]);
                                    return sum;
                                  }) /
                      static_cast<double>(shares.values.size());
  if (!(mean > 0.0)) return std::nullopt;
  const PixelWindow& w = film.window();
  for_each_row(shares.height, [&](int y) {
    float* const row = shares.row(y);
    for (int x = 0; x < shares.width; ++x)
      row[x] = static_cast<float>((std::min(row[x] / mean, kLargestShare) + kSmallestShare) *
                                  dither(w.x0 + x, w.y0 + y));
  });
  return shares;
}

} // namespace

std::uint32_t nearest_power_of_two(double wanted) {
  if (!(wanted > 1.0)) return 1;
  // The exponent of wanted sqrt(2) (IEEE 754).
  const auto bits = std::bit_cast<std::uint64_t>(wanted * std::numbers::sqrt2);
  return 1u << ((bits >> 52) - 1023);
}

std::vector<std::uint32_t> allocate_samples(const Film& film, std::span<const std::uint32_t> rays,
                                            double mean) {
  const PixelWindow& w = film.window();
  const std::size_t pixels = w.pixel_count();
  assert(rays.size() == pixels && film.keeps_errors());
  const std::optional<Map> shares = find_shares(film, rays);
  if (!shares) return std::vector<std::uint32_t>(pixels, static_cast<std::uint32_t>(mean));
  const double most = kLargestShare * mean;
  const auto samples = [&](double per_share, std::size_t pixel, std::uint32_t has) {
    return std::max(has, nearest_power_of_two(std::min(per_share * shares->values[pixel], most)));
  };
  std::vector<std::uint32_t> result(pixels);
  std::size_t pixel = 0;
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.x0; x < w.x1; ++x)
      result[pixel++] = film.samples(x, y);
  const auto total = [&](double per_share) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, pixels), std::uint64_t{0},
        [&](const auto& range, std::uint64_t sum) {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
            sum += samples(per_share, i, result[i]);
          return sum;
        },
        std::plus<>());
  };
  // Bisection in the logarithm. Shares have at most the mean 1.1 times 1.1, and none is less than
  // kSmallestShare 0.9 = 0.09: with 20 times the mean each gets 1.8 means, rounded 1.3 or more.
  const auto budget = static_cast<std::uint64_t>(mean * static_cast<double>(pixels));
  double low = 0.05 * mean, high = 20.0 * mean;
  for (int i = 0; i < 12; ++i) { // to 400^(2^-12) - 1 = 0.15 %
    const double middle = std::sqrt(low * high);
    (total(middle) > budget ? high : low) = middle;
  }
  tbb::parallel_for(std::size_t{0}, pixels,
                    [&](std::size_t i) { result[i] = samples(low, i, result[i]); });
  return result;
}

} // namespace abbe
