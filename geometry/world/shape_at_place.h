#pragma once

#include "geometry/world/shape.h"

#include <optional>

namespace abbe {

/// How a ray that begins at a place leaves it, as far as one shape is concerned.
struct Departure {
  /// The face that holds the place but for rounding. Nothing for a shape that only touches the
  /// place with an edge beside which the ray runs.
  std::optional<FaceId> face;
  /// Just behind the place the ray runs inside the solid; of a flat shape or an open mesh: on the
  /// side against the normal.
  bool inside = false;
};

/// What a shape means for a ray that begins at a place. `place_error` bounds how far the place may
/// be off where it should be.
[[nodiscard]] Departure departure(const PlacedShape& placed, const Ray& ray, double place_error);

/// How far rounding may put points of a shape's surface off where they should be.
[[nodiscard]] double surface_error(const PlacedShape& placed);

} // namespace abbe
