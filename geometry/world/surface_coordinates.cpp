#include "geometry/world/surface_coordinates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

dvec2 to_unit(double x, double y) {
  return {0.5 * (x + 1.0), 0.5 * (y + 1.0)};
}

/// The longitude about z as a part of the whole turn, in [0, 1).
double turn(const dvec3& p) {
  const double part = std::atan2(p.y, p.x) / (2.0 * std::numbers::pi);
  if (part >= 0.0) return part;
  return part + 1.0 < 1.0 ? part + 1.0 : 0.0; // rounded up to the whole turn
}

/// On the face of the box that looks along an axis, up or down it.
dvec2 on_box_face(int axis, bool up, const dvec3& p) {
  switch (axis) {
  case 0:
    return to_unit(up ? p.y : -p.y, p.z);
  case 1:
    return to_unit(up ? -p.x : p.x, p.z);
  default:
    return to_unit(up ? p.x : -p.x, p.y);
  }
}

/// By the axis to which the normal is nearest.
dvec2 by_normal(const dvec3& normal, const dvec3& p) {
  int axis = 2;
  for (const int other : {0, 1})
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  return on_box_face(axis, normal[axis] >= 0.0, p);
}

template <FlatShape S>
dvec2 coordinates(const S&, int, const dvec3& p) {
  return to_unit(p.x, p.y);
}

dvec2 coordinates(const Sphere&, int, const dvec3& p) {
  return {turn(p), 0.5 + std::asin(std::clamp(p.z, -1.0, 1.0)) / std::numbers::pi};
}

dvec2 coordinates(const Box&, int face, const dvec3& p) {
  return on_box_face(face / 2, face % 2 == 1, p);
}

dvec2 coordinates(const TaperedCylinder&, int face, const dvec3& p) {
  if (face == 0) return {turn(p), p.z};
  return on_box_face(2, face == 2, p);
}

dvec2 coordinates(const ConvexPolyhedron& solid, int face, const dvec3& p) {
  return by_normal(outward_normal(solid, p, face), p);
}

dvec2 coordinates(const Mesh& mesh, int face, const dvec3& p) {
  return by_normal(outward_normal(mesh, p, face), p);
}

dvec2 on_shape(const CsgTree& tree, FaceId face, const dvec3& p) {
  const CsgLeaf& leaf = tree.leaves()[static_cast<std::size_t>(face.leaf)];
  const dvec3 own = leaf.to_tree.inverse_point(p);
  return std::visit([&](const auto& solid) { return coordinates(solid, face.face, own); },
                    leaf.solid);
}

template <class S>
dvec2 on_shape(const S& shape, FaceId face, const dvec3& p) {
  return coordinates(shape, face.face, p);
}

} // namespace

dvec2 surface_coordinates(const PlacedShape& placed, FaceId face, const dvec3& world_point) {
  const dvec3 p = placed.to_world.inverse_point(world_point);
  return std::visit([&](const auto& shape) { return on_shape(shape, face, p); }, placed.shape);
}

} // namespace abbe
