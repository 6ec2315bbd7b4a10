#pragma once

#include <algorithm>

namespace abbe {

// How trees of reflected and refracted rays are kept from growing without bound. A branch that
// matters less than a threshold goes on with the chance of what it matters over that threshold, and
// then weighs as much more: Russian roulette, which loses no light in the mean. The threshold grows
// with the number of surfaces that the path has met. See docs/decisions/light-budgets.md.

/// So many surfaces are met before the threshold grows: few trees are deeper and still matter.
inline constexpr int kSurfacesOfTree = 16;
/// The threshold grows up to this, where two rays of a camera sample are left, but not to more than
/// `kMostGrowth` times its first value.
inline constexpr double kLargestThreshold = 0.5, kMostGrowth = 1024.0;
/// From so many surfaces on it grows beyond any bound, so that every path ends, between perfect
/// mirrors too. The chance of n surfaces then falls as 1 / n^2, so their mean number is finite.
inline constexpr int kSurfacesOfPath = 512;

/// What the growth without bound multiplies a threshold by.
[[nodiscard]] inline double path_growth(int surfaces) {
  const double beyond = std::max(1.0, static_cast<double>(surfaces) / kSurfacesOfPath);
  return beyond * beyond;
}

/// The threshold behind so many surfaces, from its value near the camera.
[[nodiscard]] inline double grown_threshold(double first, int surfaces) {
  const double ratio = std::max(1.0, static_cast<double>(surfaces) / kSurfacesOfTree);
  const double square = ratio * ratio, fourth = square * square;
  const double growth = std::min(fourth * fourth, kMostGrowth);
  return std::max(first, std::min(first * growth, kLargestThreshold)) * path_growth(surfaces);
}

} // namespace abbe
