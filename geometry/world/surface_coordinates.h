#pragma once

#include "geometry/world/shape.h"

#include <glm/vec2.hpp>

namespace abbe {

using glm::dvec2;

/// Where a point lies on a shape's surface, as patterns and images need it. `world_point` lies on
/// part `face` of the surface.
///
/// In the shape's own frame, and for an operand of a boolean in the operand's:
/// - square, disc, plane: ((x + 1) / 2, (y + 1) / 2), so the square is 0..1.
/// - sphere: longitude about z from +x over 2 pi, and latitude from 0 at z = -1 to 1 at z = 1.
/// - box: 0..1 on each face. Seen from outside, u runs to the right and v up, with z up on the four
///   sides and y up on top and bottom.
/// - cylinder and cone: on the side the longitude over 2 pi, and z; on the ends as on a disc, seen
///   from outside.
/// - polyhedra and meshes: as on the face of the box that their face looks at.
[[nodiscard]] dvec2 surface_coordinates(const PlacedShape& placed, FaceId face,
                                        const dvec3& world_point);

} // namespace abbe
