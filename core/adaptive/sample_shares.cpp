#include "core/adaptive/sample_shares.h"

#include "core/adaptive/pixel_quarter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace abbe {
namespace {

using Rgb = std::array<float, 3>;

/// Unequal shares must promise at most this part of the error of equal ones. Rounding their numbers
/// of samples to powers of two alone costs (1/2) / (ln 2)^2 = 1.04, and what they promise is
/// estimated. Measured: docs/decisions/noise.md.
constexpr double kWorthwhile = 0.9;

/// What the first round has shown of a pixel.
struct Evidence {
  Rgb mean;
  Rgb variance; ///< of the mean, as the film estimates it
  float cost;   ///< of a sample: its rays, and one more for all that is done without any
};

Rgb rgb(const Xyz& color) {
  const LinearRgb c = to_linear_srgb(color);
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

/// Sums of values that rows have given, quarter by quarter, always added in the same order.
class QuarterSums {
public:
  explicit QuarterSums(int rows) : rows_(static_cast<std::size_t>(rows)) {}

  double& at(int row, std::size_t quarter) { return rows_[static_cast<std::size_t>(row)][quarter]; }
  [[nodiscard]] double of(std::size_t quarter) const {
    double sum = 0.0;
    for (const auto& row : rows_)
      sum += row[quarter];
    return sum;
  }
  [[nodiscard]] double of_others(std::size_t quarter) const {
    double sum = 0.0;
    for (std::size_t q = 0; q < kQuarters; ++q)
      sum += q == quarter ? 0.0 : of(q);
    return sum;
  }

private:
  std::vector<std::array<double, kQuarters>> rows_;
};

/// Equal shares would take the step from one number of samples to the next all at once, and the
/// mean number of samples would miss what is wanted. So shares differ a little from pixel to pixel,
/// by Roberts's evenly spread sequence along the lattice of pixels [Roberts18].
double dither(int x, int y) {
  constexpr double kPart = 0.1; // costs less than 1 % of the gain; measured
  const double u = x * 0.7548776662466927 + y * 0.5698402909980532;
  return 1.0 + kPart * (2.0 * (u - std::floor(u)) - 1.0);
}

class ShareFinder {
public:
  ShareFinder(const Film& film, std::span<const std::uint32_t> rays);

  /// Finds the shares of one quarter.
  void find(std::size_t quarter);
  [[nodiscard]] std::vector<float> take_shares() && { return std::move(shares_); }

private:
  /// The wanted share of the pixel in column x and row y, by its neighbours except those of one
  /// quarter: the root of their variance, relative and per cost. 0 where there are none.
  [[nodiscard]] float wanted(int x, int y, std::size_t left_out) const;
  /// The relative variance of one sample, as the pixel itself shows it.
  [[nodiscard]] double own_variance(const Evidence& pixel) const;
  /// True where samples in proportion to the wanted shares are clearly better than the same number
  /// for all, for the pixels of the other quarters.
  [[nodiscard]] bool helps_others(std::size_t quarter, double mean_of_others) const;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] std::size_t quarter(int x, int y) const {
    return quarter_of(window_.x0 + x, window_.y0 + y);
  }
  template <class Use>
  void for_each(const Use& use) const {
    tbb::parallel_for(0, height_, [&](int y) {
      for (int x = 0; x < width_; ++x)
        use(x, y);
    });
  }
  /// A share as a multiple of the mean: bounded on both sides.
  static double bounded(double share, double mean) {
    return std::min(share / mean, kLargestShare) + kSmallestShare;
  }

  const PixelWindow window_;
  const int width_ = window_.width(), height_ = window_.height();
  const double samples_; ///< of each pixel
  std::vector<Evidence> evidence_;
  QuarterSums values_, pixels_; ///< sums of R, G and B, and how many pixels there are
  double floor_ = 0.0;          ///< 0.01 m^2 of the relative error
  std::vector<float> wanted_;   ///< for the quarter that is dealt with
  std::vector<float> shares_;
};

ShareFinder::ShareFinder(const Film& film, std::span<const std::uint32_t> rays)
    : window_(film.window()), samples_(film.samples(window_.x0, window_.y0)),
      evidence_(window_.pixel_count()), values_(height_), pixels_(height_),
      wanted_(window_.pixel_count()), shares_(window_.pixel_count()) {
  const auto apart = film.find(kEvidence);
  const LayerId layer = apart ? *apart : *film.find(kBeauty);
  for_each([&](int x, int y) {
    const int px = window_.x0 + x, py = window_.y0 + y;
    assert(film.samples(px, py) == samples_);
    Evidence& e = evidence_[index(x, y)];
    e.mean = rgb(
        {film.mean(layer, px, py, 0), film.mean(layer, px, py, 1), film.mean(layer, px, py, 2)});
    e.variance = rgb(film.signed_error(layer, px, py));
    for (float& v : e.variance)
      v *= v;
    e.cost = 1.0f + static_cast<float>(rays[index(x, y)] / samples_);
    values_.at(y, quarter(x, y)) += e.mean[0] + e.mean[1] + e.mean[2];
    pixels_.at(y, quarter(x, y)) += 1.0;
  });
}

float ShareFinder::wanted(int x, int y, std::size_t left_out) const {
  Rgb mean{}, square{}, variance{};
  float cost = 0.0f, weights = 0.0f;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i) {
      if ((i == x && j == y) || quarter(i, j) == left_out) continue;
      const Evidence& e = evidence_[index(i, j)];
      const float weight = i == x || j == y ? 2.0f : 1.0f;
      for (std::size_t c = 0; c < 3; ++c) {
        mean[c] += weight * e.mean[c];
        square[c] += weight * e.mean[c] * e.mean[c];
        variance[c] += weight * e.variance[c];
      }
      cost += weight * e.cost;
      weights += weight;
    }
  if (weights == 0.0f) return 0.0f;
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double m = mean[c] / weights, v = variance[c] / weights;
    // The means differ by their own variance even where the pixels are alike.
    const double between = std::max(square[c] / weights - m * m - v, 0.0);
    sum += (samples_ * v + between) / (m * m + floor_);
  }
  return static_cast<float>(std::sqrt(sum * weights / cost));
}

double ShareFinder::own_variance(const Evidence& pixel) const {
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    sum += samples_ * pixel.variance[c] / (pixel.mean[c] * pixel.mean[c] + floor_);
  return sum;
}

// With the variance v, the cost c and the share s of each pixel, the error of a given work is in
// proportion to (sum of c s) (sum of v / s).
bool ShareFinder::helps_others(std::size_t quarter_out, double mean_of_others) const {
  QuarterSums work(height_), error(height_), even_work(height_), even_error(height_);
  for_each([&](int x, int y) {
    const std::size_t q = quarter(x, y);
    if (q == quarter_out) return;
    const Evidence& e = evidence_[index(x, y)];
    const double v = own_variance(e), s = bounded(wanted_[index(x, y)], mean_of_others);
    work.at(y, q) += e.cost * s;
    error.at(y, q) += v / s;
    even_work.at(y, q) += e.cost;
    even_error.at(y, q) += v;
  });
  return work.of_others(quarter_out) * error.of_others(quarter_out) <
         kWorthwhile * even_work.of_others(quarter_out) * even_error.of_others(quarter_out);
}

void ShareFinder::find(std::size_t quarter_in) {
  const double count_of_others = pixels_.of_others(quarter_in);
  if (!(values_.of_others(quarter_in) > 0.0)) return;
  const double m = values_.of_others(quarter_in) / (3.0 * count_of_others);
  floor_ = 0.01 * m * m;
  QuarterSums sums(height_);
  for_each([&](int x, int y) {
    sums.at(y, quarter(x, y)) += wanted_[index(x, y)] = wanted(x, y, quarter_in);
  });
  const double mean = sums.of(quarter_in) / pixels_.of(quarter_in);
  const double mean_of_others = sums.of_others(quarter_in) / count_of_others;
  if (!(mean > 0.0 && mean_of_others > 0.0) || !helps_others(quarter_in, mean_of_others)) return;
  for_each([&](int x, int y) {
    if (quarter(x, y) == quarter_in)
      shares_[index(x, y)] = static_cast<float>(bounded(wanted_[index(x, y)], mean) *
                                                dither(window_.x0 + x, window_.y0 + y));
  });
}

} // namespace

std::vector<float> find_shares(const Film& film, std::span<const std::uint32_t> rays) {
  assert(rays.size() == film.window().pixel_count() && film.keeps_errors());
  ShareFinder finder(film, rays);
  for (std::size_t quarter = 0; quarter < kQuarters; ++quarter)
    finder.find(quarter);
  return std::move(finder).take_shares();
}

} // namespace abbe
