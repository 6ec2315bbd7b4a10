#pragma once

#include <array>
#include <cstddef>
#include <cstring>

namespace abbe {

// Sums and maxima over bands [first, last) in eight lanes side by side, which the compiler puts
// into one register; one after the other each step would wait for the one before. A band's lane
// depends on the band alone, so bands without power change nothing by being there.

namespace band_math {

inline constexpr int kLanes = 8;
using Lanes = std::array<float, kLanes>;
using Wide = float __attribute__((vector_size(sizeof(Lanes))));

[[nodiscard]] inline Wide loaded(const float* from) {
  Wide wide;
  std::memcpy(&wide, from, sizeof wide);
  return wide;
}

/// Calls step(lane, value of a, value of c) for all bands, with single values or eight at once.
template <class Step>
Lanes over_lanes(const float* a, const float* c, int first, int last, Step&& step) {
  Lanes lanes{};
  int b = first;
  for (; b < last && b % kLanes != 0; ++b) {
    float& lane = lanes[static_cast<std::size_t>(b % kLanes)];
    lane = step(lane, a[b], c[b]);
  }
  Wide wide = loaded(lanes.data());
  for (; b + kLanes <= last; b += kLanes)
    wide = step(wide, loaded(a + b), loaded(c + b));
  std::memcpy(lanes.data(), &wide, sizeof wide);
  for (; b < last; ++b) {
    float& lane = lanes[static_cast<std::size_t>(b % kLanes)];
    lane = step(lane, a[b], c[b]);
  }
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
  const auto step = [](auto lane, auto x, auto y) { return lane + x * y; };
  float sum = 0.0f;
  for (const float lane : band_math::over_lanes(a, c, first, last, step))
    sum += lane;
  return sum;
}

/// The largest of 0 and values[b].
[[nodiscard]] inline float largest_of(const float* values, int first, int last) {
  const auto step = [](auto lane, auto x, auto) { return x > lane ? x : lane; };
  return band_math::largest(band_math::over_lanes(values, values, first, last, step));
}

/// The largest of 0 and a[b] * c[b].
[[nodiscard]] inline float largest_product(const float* a, const float* c, int first, int last) {
  const auto step = [](auto lane, auto x, auto y) { return x * y > lane ? x * y : lane; };
  return band_math::largest(band_math::over_lanes(a, c, first, last, step));
}

} // namespace abbe
