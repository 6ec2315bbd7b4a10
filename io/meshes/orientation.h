#pragma once

#include <glm/vec2.hpp>

#include <span>

namespace abbe {

using glm::dvec2;

/// 1 where a, b and c turn to the left, -1 where they turn to the right, 0 where they lie on one
/// line. The answer is exact, without rounding, for coordinates whose magnitudes are 0 or lie
/// between 2^-484 and 2^500. (source: Shewchuk1997)
[[nodiscard]] int orientation(const dvec2& a, const dvec2& b, const dvec2& c);

/// The sign of the area that a closed line of corners encloses: 1 where it runs counter-clockwise.
/// It is exact within the same limits.
[[nodiscard]] int area_sign(std::span<const dvec2> corners);

} // namespace abbe
