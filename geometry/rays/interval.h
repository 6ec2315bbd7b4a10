#pragma once

#include "geometry/rays/ids.h"

#include <cstdint>
#include <limits>

namespace abbe {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Unit round-off of double arithmetic.
inline constexpr double kRoundoff = std::numeric_limits<double>::epsilon() / 2;

/// Names one smooth piece of a shape's boundary: which operand of a CSG tree, which face of it.
struct FaceId {
  std::int32_t leaf = 0;
  std::int32_t face = 0;
  friend bool operator==(const FaceId&, const FaceId&) = default;
};

/// Where a line crosses one face. `t_error` bounds the rounding error of `t`.
struct Root {
  double t = 0.0;
  double t_error = 0.0;
  FaceId face;
};

/// The part of a line inside a convex solid: enter.t <= exit.t; an open end is infinite.
struct Interval {
  Root enter{-kInfinity, 0.0, {}};
  Root exit{kInfinity, 0.0, {}};
};

/// The side of a surface on which a ray leaves it.
enum class Side : std::uint8_t { outside, inside };

/// A ray's origin lies exactly on this face and the ray goes to this side of it. Solvers take the
/// root of that face as t = 0 instead of computing it, so no tolerance is needed to skip it.
struct FaceContact {
  std::int32_t face = 0;
  Side side = Side::outside;
};

} // namespace abbe
