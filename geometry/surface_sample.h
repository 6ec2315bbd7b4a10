#pragma once

#include "geometry/shape.h"

#include <glm/vec2.hpp>

#include <optional>

namespace abbe {

using glm::dvec2;

/// A point on the surface of a shape in the world, chosen at random.
struct SurfaceSample {
  dvec3 point{0.0};
  dvec3 normal{0.0};    ///< unit, outwards
  FaceId face;          ///< on which the point lies
  double density = 0.0; ///< of the choice, per unit of world area
};

/// True for shapes whose surface can be sampled: square, disc, sphere, box.
[[nodiscard]] bool has_sampled_points(const Shape& shape);

/// A point of the surface for two numbers in [0, 1). Uniform in area in the shape's own frame, so
/// also in the world under similarity transforms. Nothing for shapes that cannot be sampled.
[[nodiscard]] std::optional<SurfaceSample> sample_surface(const PlacedShape& placed,
                                                          const dvec2& u);

/// The density, per unit of world area, with which `sample_surface` chooses a point where the
/// world normal is `normal`. 0 for shapes that cannot be sampled.
[[nodiscard]] double surface_density(const PlacedShape& placed, const dvec3& normal);

/// The shape's area in the world; 0 for shapes that cannot be sampled.
[[nodiscard]] double surface_area(const PlacedShape& placed);

} // namespace abbe
