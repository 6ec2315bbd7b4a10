#pragma once

#include "core/bands/band_span.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace abbe {

// Sums and maxima over bands [first, last). They are computed in eight lanes, which the compiler
// puts into one register, since a single running sum would make each step wait for the one before.
// A band's lane depends on the band alone, so that bands without power do not change the result.
// Arrays are padded like those of BandTable. A single band needs no lanes.

namespace band_math {

inline constexpr int kLanes = 8;
using Lanes = std::array<float, kLanes>;
using Wide = float __attribute__((vector_size(sizeof(Lanes))));

[[nodiscard]] inline Wide loaded(const float* from) {
  Wide wide;
  std::memcpy(&wide, from, sizeof wide);
  return wide;
}

/// Calls step(lane, value of a, value of c) for all bands, eight at once. Whole groups of eight are
/// read, which the padding allows, and lanes outside the range keep their values.
template <class Step>
Lanes over_lanes(const float* a, const float* c, int first, int last, Step&& step) {
  using Indices = std::int32_t __attribute__((vector_size(sizeof(Lanes))));
  constexpr Indices kLane{0, 1, 2, 3, 4, 5, 6, 7};
  Wide wide{};
  int group = first & -kLanes;
  const auto partly = [&] {
    const Indices band = kLane + group;
    const Wide next = step(wide, loaded(a + group), loaded(c + group));
    wide = ((band >= first) & (band < last)) ? next : wide;
  };
  if (group != first) {
    partly();
    group += kLanes;
  }
  for (; group + kLanes <= last; group += kLanes)
    wide = step(wide, loaded(a + group), loaded(c + group));
  if (group < last) partly();
  Lanes lanes;
  std::memcpy(lanes.data(), &wide, sizeof wide);
  return lanes;
}

inline float largest(const Lanes& lanes) {
  float most = 0.0f;
  for (const float lane : lanes)
    most = lane > most ? lane : most;
  return most;
}

} // namespace band_math

/// The sum of a[b] * c[b].
[[nodiscard]] inline float weighted_sum(const float* a, const float* c, int first, int last) {
  if (last - first == 1) return a[first] * c[first];
  const auto step = [](auto lane, auto x, auto y) { return lane + x * y; };
  float sum = 0.0f;
  for (const float lane : band_math::over_lanes(a, c, first, last, step))
    sum += lane;
  return sum;
}

/// The largest of 0 and values[b].
[[nodiscard]] inline float largest_of(BandSpan<const float> values) {
  const auto [first, last] = values.bands;
  if (last - first == 1) return values[first] > 0.0f ? values[first] : 0.0f;
  const auto step = [](auto lane, auto x, auto) { return x > lane ? x : lane; };
  return band_math::largest(band_math::over_lanes(values.data, values.data, first, last, step));
}

/// The largest of 0 and a[b] * c[b], for the bands of `a`.
[[nodiscard]] inline float largest_product(BandSpan<const float> a, const float* c) {
  const auto [first, last] = a.bands;
  if (last - first == 1) return a[first] * c[first] > 0.0f ? a[first] * c[first] : 0.0f;
  const auto step = [](auto lane, auto x, auto y) { return x * y > lane ? x * y : lane; };
  return band_math::largest(band_math::over_lanes(a.data, c, first, last, step));
}

/// True when no value is 0 or less.
[[nodiscard]] inline bool all_above_zero(BandSpan<const float> values) {
  // A float is above 0 when its bits are, taken as an integer, and the smallest of integers is
  // found in whole registers.
  std::int32_t least = 1;
  for (int b = values.bands.first; b < values.bands.last; ++b)
    least = std::min(least, std::bit_cast<std::int32_t>(values[b]));
  return least > 0;
}

} // namespace abbe
