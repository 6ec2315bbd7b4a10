#include "core/film/film.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

/// A sample that alone would overflow a sum.
constexpr double kLargestSteps = 0x1p62;
/// Splats are added without a lock: so many threads as there may be must fit above kLargestSteps.
constexpr double kLargestSplat = 0x1p50;

/// What a splat brings into memory of band sums in a file: about a page, whichever it is.
constexpr std::size_t kTouchedBySplat = 4096 / sizeof(std::int64_t);

std::int64_t steps(double value, double quantum) {
  return std::llround(value / quantum);
}

} // namespace

Film::Film(PixelWindow window, double quantum, int bands, bool keep_errors, BandPlace place)
    : window_(window), quantum_(quantum), bands_(bands), sums_(3 * window.pixel_count()),
      first_sums_(keep_errors ? sums_.size() : 0), place_(std::move(place)),
      band_sums_(make_band_sums()), counts_(window.pixel_count()), covered_(window.pixel_count()),
      refused_(window.pixel_count()) {}

FileBackedSums Film::make_band_sums() const {
  const std::size_t count = window_.pixel_count() * static_cast<std::size_t>(bands_);
  const bool small = count * sizeof(std::int64_t) <= place_.largest_in_memory;
  return small || place_.folder.empty() ? FileBackedSums(count)
                                        : FileBackedSums(count, place_.folder);
}

bool Film::accept(double value, std::size_t pixel) {
  auto& tally = refused_[pixel];
  if (!std::isfinite(value)) return ++tally[0], false;
  if (value < 0.0) return ++tally[1], false;
  if (value / quantum_ > kLargestSteps) return ++tally[2], false;
  return true;
}

void Film::sum(std::int64_t& total, double value, std::size_t pixel) {
  std::int64_t next = 0;
  if (__builtin_add_overflow(total, steps(value, quantum_), &next)) {
    ++refused_[pixel][2];
    return;
  }
  total = next;
}

void Film::add(int x, int y, const Xyz& color, bool covered, std::span<const float> radiance) {
  const std::size_t pixel = index(x, y);
  if (keeps_errors() && std::has_single_bit(counts_[pixel]))
    std::copy_n(sums_.data() + 3 * pixel, 3, first_sums_.data() + 3 * pixel);
  ++counts_[pixel];
  covered_[pixel] += covered ? 1u : 0u;
  if (!accept(color.x, pixel) || !accept(color.y, pixel) || !accept(color.z, pixel)) return;
  sum(sums_[3 * pixel], color.x, pixel);
  sum(sums_[3 * pixel + 1], color.y, pixel);
  sum(sums_[3 * pixel + 2], color.z, pixel);
  for (std::size_t b = 0; b < static_cast<std::size_t>(bands_); ++b)
    if (accept(radiance[b], pixel))
      sum(band_sums_[pixel * static_cast<std::size_t>(bands_) + b], radiance[b], pixel);
}

void Film::enable_splats() {
  splats_.resize(sums_.size());
  band_splats_ = make_band_sums();
}

/// Integers may be added in any order. A sum that has come near its end takes no more.
void Film::splat(std::int64_t& total, double value, double u) {
  const auto refuse = [](std::uint64_t& tally) {
    std::atomic_ref(tally).fetch_add(1, std::memory_order_relaxed);
  };
  if (!std::isfinite(value)) return refuse(refused_splats_.not_finite);
  if (value < 0.0) return refuse(refused_splats_.negative);
  const std::atomic_ref sum(total);
  if (value / quantum_ > kLargestSplat ||
      static_cast<double>(sum.load(std::memory_order_relaxed)) > kLargestSteps)
    return refuse(refused_splats_.overflow);
  sum.fetch_add(static_cast<std::int64_t>(std::floor(value / quantum_ + u)),
                std::memory_order_relaxed);
}

void Film::add_splat(int x, int y, const Xyz& color, std::span<const float> radiance, double u) {
  const std::size_t pixel = index(x, y);
  const auto round = [&](std::int64_t& total, double value) {
    splat(total, value, u);
    u += 1.0 / std::numbers::phi; // the next value is rounded on its own
    u -= std::floor(u);
  };
  round(splats_[3 * pixel], color.x);
  round(splats_[3 * pixel + 1], color.y);
  round(splats_[3 * pixel + 2], color.z);
  for (std::size_t b = 0; b < static_cast<std::size_t>(bands_); ++b)
    round(band_splats_[pixel * static_cast<std::size_t>(bands_) + b], radiance[b]);
  if (bands_ > 0) band_splats_.touched(kTouchedBySplat);
}

double Film::mean(std::int64_t sum, std::size_t pixel) const {
  return counts_[pixel] ? static_cast<double>(sum) * quantum_ / counts_[pixel] : 0.0;
}

Xyz Film::color(int x, int y) const {
  const std::size_t p = index(x, y);
  return {mean(sums_[3 * p], p) + splat_mean(splats_, 3 * p),
          mean(sums_[3 * p + 1], p) + splat_mean(splats_, 3 * p + 1),
          mean(sums_[3 * p + 2], p) + splat_mean(splats_, 3 * p + 2)};
}

Xyz Film::error(int x, int y) const {
  const Xyz e = signed_error(x, y);
  return {std::abs(e.x), std::abs(e.y), std::abs(e.z)};
}

Xyz Film::signed_error(int x, int y) const {
  const std::size_t p = index(x, y);
  const std::uint32_t n = counts_[p];
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (n < 2) return {unknown, unknown, unknown};
  const double a = std::bit_floor(n - 1), b = n - a;
  const auto error = [&](std::size_t i) {
    const auto first = static_cast<double>(first_sums_[i]);
    const double rest = static_cast<double>(sums_[i] - first_sums_[i]);
    return std::sqrt(a * b) / n * quantum_ * (first / a - rest / b);
  };
  return {error(3 * p), error(3 * p + 1), error(3 * p + 2)};
}

double Film::alpha(int x, int y) const {
  const std::size_t p = index(x, y);
  return counts_[p] ? static_cast<double>(covered_[p]) / counts_[p] : 0.0;
}

double Film::radiance(int x, int y, int band) const {
  const std::size_t p = index(x, y);
  const std::size_t i = p * static_cast<std::size_t>(bands_) + static_cast<std::size_t>(band);
  return mean(band_sums_[i], p) + splat_mean(band_splats_, i);
}

Film::Refused Film::refused() const {
  Refused total = refused_splats_;
  for (const auto& tally : refused_) {
    total.not_finite += tally[0];
    total.negative += tally[1];
    total.overflow += tally[2];
  }
  return total;
}

} // namespace abbe
