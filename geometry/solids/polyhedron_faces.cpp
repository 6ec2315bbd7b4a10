#include "geometry/solids/polyhedron_faces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// The part of a convex polygon in the half-space [Sutherland74].
std::vector<dvec3> clipped(const std::vector<dvec3>& polygon, const HalfSpace& half_space) {
  const auto above = [&](const dvec3& p) {
    return glm::dot(half_space.normal, p) - half_space.offset;
  };
  std::vector<dvec3> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = above(a), to = above(b);
    if (from <= 0.0) rest.push_back(a);
    if ((from <= 0.0) != (to <= 0.0)) rest.push_back(a + from / (from - to) * (b - a));
  }
  return rest.size() < 3 ? std::vector<dvec3>() : rest;
}

bool same(const HalfSpace& a, const HalfSpace& b) {
  return a.normal == b.normal && a.offset == b.offset;
}

} // namespace

std::vector<dvec3> face_corners(const ConvexPolyhedron& solid, int face) {
  const std::vector<HalfSpace>& planes = solid.half_spaces();
  const auto own = static_cast<std::size_t>(face);
  const dvec3 normal = planes[own].normal;
  double reach = 0.0;
  for (const dvec3& vertex : solid.vertices())
    reach = std::max(reach, glm::length(vertex));

  // A square of the plane that holds the whole face: it is no wider than the solid.
  const dvec3 off_axis = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 x = 2.0 * reach * glm::normalize(glm::cross(off_axis, normal));
  const dvec3 y = glm::cross(normal, x);
  const dvec3 middle = planes[own].offset * normal;
  std::vector<dvec3> polygon{middle - x - y, middle + x - y, middle + x + y, middle - x + y};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (i < own && same(planes[i], planes[own])) return {};
    if (i != own && !same(planes[i], planes[own])) polygon = clipped(polygon, planes[i]);
  }
  return polygon;
}

} // namespace abbe
