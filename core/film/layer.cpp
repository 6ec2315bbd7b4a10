#include "core/film/layer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

/// A sample that alone would overflow a sum.
constexpr double kLargestSteps = 0x1p62;
/// Splats are added without a lock: so many threads as there may be must fit above kLargestSteps.
constexpr double kLargestSplat = 0x1p50;

/// Of the kind `nearest` a sum is this less the value in quanta, so that 0 stands for none.
constexpr std::int64_t kFar = std::int64_t{1} << 53;

/// What a splat brings into memory of band sums in a file: about a page, whichever it is.
constexpr std::size_t kTouchedBySplat = 4096 / sizeof(std::int64_t);

[[maybe_unused]] bool power_of_two(double value) {
  int exponent = 0;
  return std::frexp(value, &exponent) == 0.5;
}

/// Several threads may refuse at once.
void count(std::uint64_t& tally) {
  std::atomic_ref(tally).fetch_add(1, std::memory_order_relaxed);
}

/// True for a value of a colour or a band that can be summed; it is `steps` quanta.
bool fits(double value, double steps) {
  return value >= 0.0 && steps <= kLargestSteps;
}

/// Counts why a value does not fit.
[[gnu::noinline]] bool refuse(double value, RefusedValues& refused, bool is_signed = false) {
  if (!std::isfinite(value))
    count(refused.not_finite);
  else if (value < 0.0 && !is_signed)
    count(refused.negative);
  else
    count(refused.overflow);
  return false;
}

/// Adds to the sum of all samples, and to that of the first stratum unless it is null.
void sum_up(std::int64_t& total, std::int64_t* first, std::int64_t more, RefusedValues& refused) {
  std::int64_t next = 0;
  if (__builtin_add_overflow(total, more, &next)) return count(refused.overflow);
  total = next;
  if (first) *first += more;
}

FileBackedSums make_sums(const LayerForm& form, std::size_t pixels, const BandPlace& place) {
  const std::size_t sums = pixels * form.values();
  const bool in_memory =
      place.folder.empty() || sums * sizeof(std::int64_t) <= place.largest_in_memory;
  return in_memory ? FileBackedSums(sums) : FileBackedSums(sums, place.folder, place.resident);
}

} // namespace

std::size_t LayerForm::values() const {
  switch (kind) {
  case LayerKind::xyz:
    return 3;
  case LayerKind::bands:
    return static_cast<std::size_t>(bands);
  case LayerKind::value:
  case LayerKind::nearest:
    return 1;
  case LayerKind::ids:
    break;
  }
  return 0;
}

Layer::Layer(LayerForm form, std::size_t pixels, const BandPlace& place)
    : form_(std::move(form)), values_(form_.values()), sums_(make_sums(form_, pixels, place)),
      ids_(form_.kind == LayerKind::ids ? pixels : 0) {
  assert(power_of_two(form_.quantum));
  if (form_.strata) first_sums_ = make_sums(form_, pixels, place);
}

bool Layer::add(std::size_t pixel, Stratum stratum, const Xyz& color, RefusedValues& refused) {
  assert(form_.kind == LayerKind::xyz);
  const double x = color.x / form_.quantum, y = color.y / form_.quantum,
               z = color.z / form_.quantum;
  if (!fits(color.x, x)) return refuse(color.x, refused);
  if (!fits(color.y, y)) return refuse(color.y, refused);
  if (!fits(color.z, z)) return refuse(color.z, refused);
  std::int64_t* const sums = &sums_[3 * pixel];
  std::int64_t* const first = first_sums(3 * pixel, stratum);
  sum_up(sums[0], first, std::llround(x), refused);
  sum_up(sums[1], first ? first + 1 : nullptr, std::llround(y), refused);
  sum_up(sums[2], first ? first + 2 : nullptr, std::llround(z), refused);
  return true;
}

bool Layer::add(std::size_t pixel, Stratum stratum, double value, RefusedValues& refused) {
  assert(form_.kind == LayerKind::value || form_.kind == LayerKind::nearest);
  const double steps = value / form_.quantum;
  if (form_.kind == LayerKind::nearest) return come_near(pixel, steps, refused);
  if (!(std::abs(steps) <= kLargestSteps)) return refuse(value, refused, true);
  sum_up(sums_[pixel], first_sums(pixel, stratum), std::llround(steps), refused);
  return true;
}

bool Layer::come_near(std::size_t pixel, double steps, RefusedValues& refused) {
  if (!(steps >= 0.0 && steps < static_cast<double>(kFar))) return refuse(steps, refused);
  sums_[pixel] = std::max<std::int64_t>(sums_[pixel], kFar - std::llround(steps));
  return true;
}

std::optional<double> Layer::nearest(std::size_t pixel) const {
  if (sums_[pixel] == 0) return std::nullopt;
  return static_cast<double>(kFar - sums_[pixel]) * form_.quantum;
}

void Layer::add(std::size_t pixel, Stratum stratum, const ColorSteps& steps,
                RefusedValues& refused) {
  assert(form_.kind == LayerKind::xyz);
  std::int64_t* const first = first_sums(3 * pixel, stratum);
  for (std::size_t i = 0; i < steps.size(); ++i)
    sum_up(sums_[3 * pixel + i], first ? first + i : nullptr, steps[i], refused);
}

void Layer::add(std::size_t pixel, Stratum stratum, std::span<const float> radiance,
                RefusedValues& refused) {
  assert(form_.kind == LayerKind::bands && radiance.size() == values_);
  const double quantum = form_.quantum;
  std::int64_t* sum = &sums_[values_ * pixel];
  std::int64_t* first = first_sums(values_ * pixel, stratum);
  for (const double value : radiance) {
    const double steps = value / quantum;
    if (fits(value, steps))
      sum_up(*sum, first, std::llround(steps), refused);
    else
      refuse(value, refused);
    ++sum;
    if (first) ++first;
  }
}

void Layer::close_first_stratum(std::size_t pixel) {
  for (std::size_t i = pixel * values_; i < (pixel + 1) * values_; ++i)
    first_sums_[i] = sums_[i];
}

/// Integers may be added in any order. A sum that has come near its end takes no more.
void Layer::splat_value(std::size_t i, double value, double& u, RefusedValues& refused) {
  const double up = u;
  u += 1.0 / std::numbers::phi; // the next value is rounded on its own
  u -= std::floor(u);
  if (!std::isfinite(value)) return count(refused.not_finite);
  if (value < 0.0) return count(refused.negative);
  const std::atomic_ref sum(sums_[i]);
  if (value / form_.quantum > kLargestSplat ||
      static_cast<double>(sum.load(std::memory_order_relaxed)) > kLargestSteps)
    return count(refused.overflow);
  sum.fetch_add(static_cast<std::int64_t>(std::floor(value / form_.quantum + up)),
                std::memory_order_relaxed);
}

void Layer::splat(std::size_t pixel, const Xyz& color, double& u, RefusedValues& refused) {
  splat_value(3 * pixel, color.x, u, refused);
  splat_value(3 * pixel + 1, color.y, u, refused);
  splat_value(3 * pixel + 2, color.z, u, refused);
}

void Layer::splat(std::size_t pixel, std::span<const float> radiance, double& u,
                  RefusedValues& refused) {
  for (std::size_t b = 0; b < values_; ++b)
    splat_value(pixel * values_ + b, radiance[b], u, refused);
  sums_.touched(kTouchedBySplat);
}

void Layer::merge(const Layer& other, std::size_t pixel, bool all_first, RefusedValues& refused) {
  assert(form_ == other.form_);
  if (form_.kind == LayerKind::nearest) {
    sums_[pixel] = std::max(sums_[pixel], other.sums_[pixel]);
    return;
  }
  for (std::size_t i = pixel * values_; i < (pixel + 1) * values_; ++i) {
    std::int64_t next = 0;
    if (__builtin_add_overflow(sums_[i], other.sums_[i], &next)) {
      count(refused.overflow);
      continue;
    }
    sums_[i] = next;
    if (form_.strata) first_sums_[i] += all_first ? other.sums_[i] : other.first_sums_[i];
  }
  if (form_.kind == LayerKind::ids)
    for (const IdCount& pair : other.ids_.of(pixel))
      ids_.add(pixel, pair.id, pair.count);
}

} // namespace abbe
