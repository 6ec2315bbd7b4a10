#include "core/denoise/denoiser.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace abbe {
namespace {

using Plane = DenoiseGuide::Plane;

/// Colours are alike that differ by less than this many standard errors.
constexpr float kErrors = 0.7f;
/// Where there is no noise, pixels are mixed that differ by less than this part of their sum.
constexpr float kAlike = 1e-3f;
/// A pixel's variance is the mean over those that are at most so far away.
constexpr int kVarianceReach = 3;
/// It is no less than this times what its own two halves tell: a bright sample may be alone.
constexpr float kOwnVariance = 2.0f;
/// So many times the weights are scaled to bring their sums near 1.
constexpr int kScalings = 4;
/// The rows that one task takes together.
constexpr int kTaskRows = 16;
/// So many rows are filtered at a time, which bounds the memory that their weights take.
constexpr int kStripRows = 128;

std::size_t place(int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
}

/// Means over squares; at the edge the outermost values stand for those beyond it.
Plane mean_around(const Plane& plane, int width, int height, int reach) {
  const auto pass = [reach](const float* from, float* to, int count, std::size_t step) {
    const auto at = [&](int i) {
      return static_cast<double>(
          from[static_cast<std::size_t>(std::clamp(i, 0, count - 1)) * step]);
    };
    for (int i = 0; i < count; ++i) {
      double sum = 0.0;
      for (int k = -reach; k <= reach; ++k)
        sum += at(i + k);
      to[static_cast<std::size_t>(i) * step] = static_cast<float>(sum / (2 * reach + 1));
    }
  };
  Plane rows(plane.size()), result(plane.size());
  for (int y = 0; y < height; ++y)
    pass(plane.data() + place(y, width), rows.data() + place(y, width), width, 1);
  for (int x = 0; x < width; ++x)
    pass(rows.data() + x, result.data() + x, height, static_cast<std::size_t>(width));
  return result;
}

/// Near exp(-x), and 0 from 16 on.
float falling(float x) {
  const float a = std::max(0.0f, 1.0f - x * (1.0f / 16.0f));
  const float b = a * a, c = b * b, d = c * c;
  return d * d;
}

/// The columns whose neighbour at this offset lies within the picture.
std::pair<int, int> columns_with_neighbor(int dx, int width) {
  return {std::max(0, -dx), width - std::max(0, dx)};
}

DenoiseRows widened(DenoiseRows rows, int by, int height) {
  return {std::max(0, rows.first - by), std::min(height, rows.last + by)};
}

template <class Body>
void for_rows(DenoiseRows rows, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<int>(rows.first, rows.last, kTaskRows),
                    [&](const auto& range) { body(DenoiseRows{range.begin(), range.end()}); });
}

} // namespace

void DenoiseWeights::gather(int y, const float* plane, DenoiseRows within, float* sums) const {
  std::fill(sums, sums + width_, 0.0f);
  for (const Neighbor& neighbor : neighbors_) {
    const int dx = neighbor.dx;
    const auto [begin, end] = columns_with_neighbor(dx, width_);
    if (const int below = y + neighbor.dy; below < within.last) {
      const float* const weights = neighbor.weights.data() + place(y - known_.first, width_);
      const float* const values = plane + place(below - within.first, width_);
      for (int x = begin; x < end; ++x)
        sums[x] += weights[x] * values[x + dx];
    }
    if (const int above = y - neighbor.dy; above >= within.first) {
      const float* const weights = neighbor.weights.data() + place(above - known_.first, width_);
      const float* const values = plane + place(above - within.first, width_);
      for (int x = begin; x < end; ++x)
        sums[x + dx] += weights[x] * values[x];
    }
  }
}

/// Finds the scales with which each pixel's weights, with 1 for itself, add up to nearly 1.
/// (source: Sinkhorn's iteration for symmetric matrices, Knight2014)
void DenoiseWeights::balance() {
  scale_.assign(place(known_.count(), width_), 1.0f);
  std::vector<float> next(scale_.size());
  for (int i = 0; i < kScalings; ++i) {
    for_rows(known_, [&](DenoiseRows rows) {
      std::vector<float> sums(static_cast<std::size_t>(width_));
      for (int y = rows.first; y < rows.last; ++y) {
        gather(y, scale_.data(), known_, sums.data());
        const std::size_t row = place(y - known_.first, width_);
        for (std::size_t x = 0; x < sums.size(); ++x) {
          const float scale = scale_[row + x];
          next[row + x] = std::sqrt(scale / (sums[x] + scale));
        }
      }
    });
    std::swap(scale_, next);
  }
}

/// What the neighbours leave is the pixel's own.
void DenoiseWeights::find_own_shares() {
  own_.resize(place(rows_.count(), width_));
  for_rows(rows_, [&](DenoiseRows rows) {
    for (int y = rows.first; y < rows.last; ++y) {
      float* const own = own_.data() + place(y - rows_.first, width_);
      const float* const scale = scale_.data() + place(y - known_.first, width_);
      gather(y, scale_.data(), known_, own);
      for (int x = 0; x < width_; ++x)
        own[x] = 1.0f - scale[x] * own[x];
    }
  });
}

void DenoiseWeights::apply(const float* source, float* target) const {
  const float* const scale = scale_.data() + place(sources_.first - known_.first, width_);
  std::vector<float> scaled(place(sources_.count(), width_));
  for (std::size_t i = 0; i < scaled.size(); ++i)
    scaled[i] = scale[i] * source[i];
  for_rows(rows_, [&](DenoiseRows rows) {
    for (int y = rows.first; y < rows.last; ++y) {
      const std::size_t from = place(y - sources_.first, width_);
      const float* const own = own_.data() + place(y - rows_.first, width_);
      float* const to = target + place(y - rows_.first, width_);
      gather(y, scaled.data(), sources_, to);
      for (int x = 0; x < width_; ++x)
        to[x] = own[x] * source[from + static_cast<std::size_t>(x)] +
                scale[from + static_cast<std::size_t>(x)] * to[x];
    }
  });
}

Denoiser::Denoiser(DenoiseGuide guide) : guide_(std::move(guide)) {
  for (std::size_t c = 0; c < 3; ++c) {
    const Plane &color = guide_.color[c], &noise = guide_.noise[c];
    Plane squares(noise.size());
    first_[c].resize(color.size());
    second_[c].resize(color.size());
    for (std::size_t i = 0; i < color.size(); ++i) {
      first_[c][i] = color[i] + noise[i];
      second_[c][i] = color[i] - noise[i];
      squares[i] = noise[i] * noise[i];
    }
    variance_[c] = mean_around(squares, width(), height(), kVarianceReach);
    for (std::size_t i = 0; i < squares.size(); ++i)
      variance_[c][i] = std::max(variance_[c][i], kOwnVariance * squares[i]);
  }
}

/// Adds to a row of pixels how far their colours are from those of their neighbours, in standard
/// errors, squared. The product of the differences in two independent pictures is right in the
/// mean, where the square of the picture's difference would have its noise in it.
void Denoiser::add_color_differences(int y, int dx, int dy, float* differences) const {
  const auto [begin, end] = columns_with_neighbor(dx, width());
  const std::size_t here = place(y, width()), there = place(y + dy, width());
  constexpr float kLeast = 1e-30f; // two black pixels are alike
  for (std::size_t c = 0; c < 3; ++c) {
    const float *const a = first_[c].data() + here, *const a2 = first_[c].data() + there + dx;
    const float *const b = second_[c].data() + here, *const b2 = second_[c].data() + there + dx;
    const float *const v = variance_[c].data() + here, *const v2 = variance_[c].data() + there + dx;
    const float *const m = guide_.color[c].data() + here, *const m2 =
                                                              guide_.color[c].data() + there + dx;
    for (int x = begin; x < end; ++x) {
      const float square = (a[x] - a2[x]) * (b[x] - b2[x]);
      const float sum = kAlike * (m[x] + m2[x]);
      differences[x] += square / (kErrors * kErrors * (v[x] + v2[x]) + sum * sum + kLeast);
    }
  }
}

void Denoiser::find_weights(DenoiseWeights::Neighbor& neighbor, DenoiseRows known,
                            DenoiseRows rows) const {
  const int dx = neighbor.dx, dy = neighbor.dy;
  const auto [begin, end] = columns_with_neighbor(dx, width());
  const auto row_size = static_cast<std::size_t>(width());
  rows.last = std::min(rows.last, height() - dy); // others have no such neighbour
  if (rows.count() <= 0 || begin >= end) return;
  // Differences are taken as means over 3 x 3 pixels.
  const DenoiseRows around = widened(rows, 1, height() - dy);
  std::vector<float> differences(row_size * static_cast<std::size_t>(around.count()));
  std::vector<float> sums(row_size), apart(row_size);
  for (int y = around.first; y < around.last; ++y)
    add_color_differences(y, dx, dy, differences.data() + place(y - around.first, width()));
  for (int y = rows.first; y < rows.last; ++y) {
    const auto row = [&](int of) {
      return differences.data() +
             place(std::clamp(of, around.first, around.last - 1) - around.first, width());
    };
    const float *const above = row(y - 1), *const here = row(y), *const below = row(y + 1);
    for (int x = begin; x < end; ++x)
      sums[static_cast<std::size_t>(x)] = above[x] + here[x] + below[x];
    std::fill(apart.begin(), apart.end(), 0.0f);
    for (const Plane& feature : guide_.features) {
      const float* const f = feature.data() + place(y, width());
      const float* const f2 = feature.data() + place(y + dy, width()) + dx;
      for (int x = begin; x < end; ++x) {
        const float difference = f[x] - f2[x];
        apart[static_cast<std::size_t>(x)] += difference * difference;
      }
    }
    float* const weights = neighbor.weights.data() + place(y - known.first, width());
    const auto weigh = [&](int x, int left, int right) {
      constexpr float kMean = 1.0f / (9 * 3); // pixels and colours
      const float color =
          kMean * (sums[static_cast<std::size_t>(left)] + sums[static_cast<std::size_t>(x)] +
                   sums[static_cast<std::size_t>(right)]);
      weights[x] = falling(std::max(0.0f, color) + apart[static_cast<std::size_t>(x)]);
    };
    weigh(begin, begin, std::min(begin + 1, end - 1));
    for (int x = begin + 1; x < end - 1; ++x)
      weigh(x, x - 1, x + 1);
    if (end - begin > 1) weigh(end - 1, end - 2, end - 1);
  }
}

DenoiseWeights Denoiser::weights(DenoiseRows rows) const {
  DenoiseWeights result;
  result.width_ = width();
  result.height_ = height();
  result.rows_ = rows;
  result.sources_ = widened(rows, kReach, height());
  // Each scaling looks as far again, so that the outermost rows' are wrong and not used.
  result.known_ = widened(rows, kReach * (kScalings + 1), height());
  for (int dy = 0; dy <= kReach; ++dy)
    for (int dx = dy == 0 ? 1 : -kReach; dx <= kReach; ++dx)
      result.neighbors_.push_back(
          {dx, dy, std::vector<float>(place(result.known_.count(), width()))});
  for_rows(result.known_, [&](DenoiseRows part) {
    for (DenoiseWeights::Neighbor& neighbor : result.neighbors_)
      find_weights(neighbor, result.known_, part);
  });
  result.balance();
  result.find_own_shares();
  return result;
}

std::vector<Plane> Denoiser::filtered(const std::vector<Plane>& planes) const {
  std::vector<Plane> result;
  for (const Plane& plane : planes)
    result.emplace_back(plane.size());
  for (int y = 0; y < height(); y += kStripRows) {
    const DenoiseWeights strip = weights({y, std::min(y + kStripRows, height())});
    for (std::size_t i = 0; i < planes.size(); ++i)
      strip.apply(planes[i].data() + place(strip.sources().first, width()),
                  result[i].data() + place(y, width()));
  }
  return result;
}

} // namespace abbe
