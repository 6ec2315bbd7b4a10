// Points of surfaces regardless of who sees them: where the light paths of emitting shapes begin.

#include "core/emitters/sampled_surface.h"

#include "geometry/solids/disc_point.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace abbe {

dvec3 sphere_point(const dvec2& u) {
  const double z = 1.0 - 2.0 * u.x;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * circle_point(u.y), z};
}

SurfacePoint FlatSurface::at(const dvec2& u) const {
  const dvec2 p = disc ? disc_point(u) : u;
  return {origin + p.x * x + p.y * y, normal, {}, 1.0 / size};
}

SurfacePoint BallSurface::at(const dvec2& u) const {
  const dvec3 normal = sphere_point(u);
  return {centre + radius * normal, normal, {}, 1.0 / area()};
}

SurfacePoint EllipsoidSurface::at(const dvec2& u) const {
  const dvec3 local = sphere_point(u);
  const dvec3 normal = to_world.normal(local);
  return {to_world.point(local), normal, {}, area_pdf(normal)};
}

SurfacePoint BoxSurface::at(const dvec2& u) const {
  const double total = area();
  double rest = u.x * total;
  std::size_t axis = 0;
  while (axis < 2 && rest >= 2.0 * face_area[axis])
    rest -= 2.0 * face_area[axis++];
  double x = std::min(rest / face_area[axis], 2.0);
  const bool upper = x >= 1.0;
  if (upper) x -= 1.0;
  const double side = upper ? 1.0 : -1.0;
  const dvec3 point = centre + side * half[axis] + (2.0 * x - 1.0) * half[(axis + 1) % 3] +
                      (2.0 * u.y - 1.0) * half[(axis + 2) % 3];
  const int face = 2 * static_cast<int>(axis) + (upper ? 1 : 0);
  return {point, side * normal[axis], {0, face}, 1.0 / total};
}

SurfacePoint PolyhedronSurface::at(const dvec2& u) const {
  double rest = u.x * whole_area;
  std::size_t i = 0;
  while (i + 1 < parts.size() && rest >= parts[i].area)
    rest -= parts[i++].area;
  const Part& part = parts[i];
  const dvec3 point = triangle_point(part.triangle, std::min(rest / part.area, 1.0), u.y);
  return {point, part.normal, {0, part.face}, 1.0 / whole_area};
}

SurfacePoint MeshSurface::at(const dvec2& u) const {
  double x = u.x;
  const int chosen = choose(x);
  const TriangleEdges edges = triangle(chosen);
  return {triangle_point(edges, x, u.y), normal(edges), {0, chosen}, 1.0 / area()};
}

TriangleEdges MeshSurface::triangle(int i) const {
  const dvec3 a = mesh->corner(i, 0);
  return {to_world.point(a), to_world.vector(mesh->corner(i, 1) - a),
          to_world.vector(mesh->corner(i, 2) - a)};
}

dvec3 MeshSurface::normal(const TriangleEdges& t) const {
  return glm::normalize(glm::cross(t.ab, t.ac)) * (mirrored ? -1.0 : 1.0);
}

int MeshSurface::choose(double& u) const {
  const double goal = u * cumulative.back();
  const auto chosen = std::upper_bound(cumulative.begin(), cumulative.end() - 1, goal);
  const double below = chosen == cumulative.begin() ? 0.0 : *(chosen - 1);
  u = std::clamp((goal - below) / (*chosen - below), 0.0, 1.0);
  return static_cast<int>(chosen - cumulative.begin());
}

dvec3 triangle_point(const TriangleEdges& t, double u, double v) {
  const double root = std::sqrt(u);
  return t.corner + root * (1.0 - v) * t.ab + root * v * t.ac;
}

} // namespace abbe
