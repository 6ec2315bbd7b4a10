#pragma once

#include "geometry/booleans/csg.h"

namespace abbe {

/// A round lens about the z axis, by the data of a prescription. Light travels along +z; a radius
/// above 0 has its centre on that side of its vertex. A radius of 0 is a flat surface.
struct LensElement {
  double front_radius = 0.0, back_radius = 0.0;
  double thickness = 1.0; ///< from vertex to vertex
  double diameter = 1.0;
  double front_vertex = 0.0; ///< its z

  [[nodiscard]] double back_vertex() const { return front_vertex + thickness; }
};

/// How far a surface with this radius of curvature lies behind its vertex (along +z) at a height
/// above the axis that is not above the radius.
[[nodiscard]] double sag(double radius, double height);

/// The lens as a tree: a cylinder, of which each convex surface's ball leaves what it holds, and
/// each concave one's takes that away. Elements whose surfaces coincide are built with the same
/// ball, so that a World finds one boundary there. Throws std::invalid_argument when the data
/// describe no lens.
[[nodiscard]] CsgTree lens_element(const LensElement& element, MaterialId material = {});

} // namespace abbe
