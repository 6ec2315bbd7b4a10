#include "tests/geometry/reference.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <type_traits>

namespace abbe::reference {
namespace {

struct LeafRoot {
  Real t;
  int leaf, face;
};

/// Roots of the ball: half a chord before and behind the point of the line nearest to the centre.
void ball_roots(const Vec& o, const Vec& d, int leaf, std::vector<LeafRoot>& roots) {
  const Real speed = glm::length(d);
  const Vec u = d / speed;
  const Real along = glm::dot(o, u);
  const Vec nearest = o - along * u;
  const Real square = 1 - glm::dot(nearest, nearest);
  if (square < 0) return;
  const Real half = std::sqrt(square);
  roots.push_back({(-along - half) / speed, leaf, 0});
  roots.push_back({(-along + half) / speed, leaf, 0});
}

/// A plane's root counts where the point on it lies under all the other planes.
void plane_roots(const Leaf& leaf, const Vec& o, const Vec& d, int index,
                 std::vector<LeafRoot>& roots) {
  Real first = -INFINITY, last = INFINITY;
  int first_face = -1, last_face = -1;
  for (std::size_t i = 0; i < leaf.planes.size(); ++i) {
    const Vec n(leaf.planes[i].normal);
    const Real speed = glm::dot(n, d), height = glm::dot(n, o) - leaf.planes[i].offset;
    if (speed == 0 && height > 0) return;
    if (speed < 0 && -height / speed > first) first = -height / speed, first_face = int(i);
    if (speed > 0 && -height / speed < last) last = -height / speed, last_face = int(i);
  }
  if (first > last) return;
  roots.push_back({first, index, first_face});
  roots.push_back({last, index, last_face});
}

/// Roots of the side's equation and of the caps count where they lie on the solid's boundary.
void taper_roots(const Leaf& leaf, const Vec& from, const Vec& d, int index,
                 std::vector<LeafRoot>& roots) {
  // From the point of the line nearest to the middle, so that the equation does not cancel.
  const Real shift = -glm::dot(from - Vec(0, 0, 0.5L), d) / glm::dot(d, d);
  const Vec o = from + shift * d;
  const Real k = *leaf.taper - 1, r = 1 + k * o.z, dr = k * d.z;
  const Real a = d.x * d.x + d.y * d.y - dr * dr;
  const Real b = o.x * d.x + o.y * d.y - r * dr;
  const Real w_x = r * d.x - dr * o.x, w_y = r * d.y - dr * o.y, moment = o.x * d.y - o.y * d.x;
  const Real square = w_x * w_x + w_y * w_y - moment * moment;
  if (square >= 0 && a != 0)
    for (const Real sign : {-1.0L, 1.0L}) {
      const Real t = (-b + sign * std::sqrt(square)) / a, z = o.z + t * d.z;
      if (z >= 0 && z <= 1 && 1 + k * z >= 0) roots.push_back({t + shift, index, 0});
    }
  for (const int face : {1, 2}) {
    const Real t = (face - 1 - o.z) / d.z;
    if (d.z != 0 && std::hypot(o.x + t * d.x, o.y + t * d.y) <= (face == 1 ? 1 : *leaf.taper))
      roots.push_back({t + shift, index, face});
  }
}

} // namespace

bool Leaf::contains(const Vec& world) const {
  const Vec p = inverse * (world - offset);
  if (taper) return p.z > 0 && p.z < 1 && std::hypot(p.x, p.y) < 1 + (*taper - 1) * p.z;
  if (planes.empty()) return glm::dot(p, p) < 1;
  return std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
    return glm::dot(Vec(h.normal), p) < Real(h.offset);
  });
}

Real Leaf::clearance(const Vec& world) const {
  // A level set's distance is its value over the length of its gradient, M^-T n.
  const Vec p = inverse * (world - offset);
  if (taper) {
    const Real rho = std::hypot(p.x, p.y), k = *taper - 1;
    const Vec side = rho == 0 ? Vec(0, 0, 1) : Vec(p.x / rho, p.y / rho, -k);
    const Vec up(0, 0, 1);
    return std::min({std::abs(rho - 1 - k * p.z) / glm::length(side * inverse),
                     std::abs(p.z) / glm::length(up * inverse),
                     std::abs(p.z - 1) / glm::length(up * inverse)});
  }
  if (planes.empty()) {
    const Real r = glm::length(p);
    return r == 0 ? 1e30L : std::abs(r - 1) / glm::length(p / r * inverse);
  }
  Real smallest = INFINITY;
  for (const HalfSpace& h : planes) {
    const Vec n(h.normal);
    smallest = std::min(smallest, std::abs(glm::dot(n, p) - h.offset) / glm::length(n * inverse));
  }
  return smallest;
}

Vec Leaf::normal(int face, const Vec& world) const {
  if (taper) {
    const Vec p = inverse * (world - offset);
    const Vec side(p.x, p.y, (1 - *taper) * std::hypot(p.x, p.y));
    return glm::normalize((face == 0 ? side : Vec(0, 0, face == 1 ? -1 : 1)) * inverse);
  }
  const Vec n = planes.empty() ? inverse * (world - offset) : Vec(planes[std::size_t(face)].normal);
  return glm::normalize(n * inverse);
}

bool Solid::contains(const Vec& world) const {
  if (flat) return false;
  std::array<bool, 64> stack{};
  std::size_t top = 0;
  for (const Step& step : steps) {
    if (step.leaf >= 0) {
      stack[top++] = leaves[std::size_t(step.leaf)].contains(world);
      continue;
    }
    const bool b = stack[--top], a = stack[top - 1];
    stack[top - 1] = step.operation == CsgOperation::unite       ? a || b
                     : step.operation == CsgOperation::intersect ? a && b
                                                                 : a && !b;
  }
  return stack[0];
}

Real Solid::clearance(const Vec& world) const {
  Real smallest = INFINITY;
  if (flat) return smallest;
  for (const Leaf& leaf : leaves)
    smallest = std::min(smallest, leaf.clearance(world));
  return smallest;
}

std::vector<Crossing> Solid::crossings(const Vec& origin, const Vec& direction, Real tie) const {
  if (flat) {
    const Leaf& plane = leaves[0];
    const Vec o = plane.inverse * (origin - plane.offset), d = plane.inverse * direction;
    if (d.z == 0) return {};
    const Real t = -o.z / d.z;
    const Real x = std::abs(o.x + t * d.x), y = std::abs(o.y + t * d.y);
    if (!endless && (round ? x * x + y * y > 1 : x > 1 || y > 1)) return {};
    return {{t, d.z < 0, 0, 0, glm::normalize(Vec(0, 0, 1) * plane.inverse)}};
  }
  std::vector<LeafRoot> roots;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Vec o = leaves[i].inverse * (origin - leaves[i].offset);
    const Vec d = leaves[i].inverse * direction;
    if (leaves[i].taper)
      taper_roots(leaves[i], o, d, int(i), roots);
    else if (leaves[i].planes.empty())
      ball_roots(o, d, int(i), roots);
    else
      plane_roots(leaves[i], o, d, int(i), roots);
  }
  std::sort(roots.begin(), roots.end(),
            [](const LeafRoot& a, const LeafRoot& b) { return a.t < b.t; });
  std::vector<Crossing> found;
  bool inside = false;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (i + 1 < roots.size() && roots[i + 1].t - roots[i].t <= tie) continue;
    const bool now =
        i + 1 < roots.size() && contains(origin + (roots[i].t + roots[i + 1].t) / 2 * direction);
    if (now == inside) continue;
    inside = now;
    Vec n =
        leaves[std::size_t(roots[i].leaf)].normal(roots[i].face, origin + roots[i].t * direction);
    if ((glm::dot(n, direction) < 0) != now) n = -n; // a subtracted leaf
    found.push_back({roots[i].t, now, roots[i].leaf, roots[i].face, n});
  }
  return found;
}

void Solid::move(const glm::dmat3& linear, const dvec3& by) {
  for (Leaf& leaf : leaves) {
    leaf.offset = Mat(linear) * leaf.offset + Vec(by);
    leaf.linear = Mat(linear) * leaf.linear;
    leaf.inverse = glm::inverse(leaf.linear);
  }
}

Twin sphere() {
  return {{Sphere{}, {}, {}, {}, 0}, {{Leaf{}}, {{0, {}}}, false}};
}

Twin box() {
  Leaf leaf;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      dvec3 n(0.0);
      n[axis] = sign;
      leaf.planes.push_back({n, 1.0});
    }
  return {{Box{}, {}, {}, {}, 0}, {{leaf}, {{0, {}}}, false}};
}

Twin square() {
  return {{Square{}, {}, {}, {}, 0}, {{Leaf{}}, {{0, {}}}, true}};
}

Twin disc() {
  Twin twin{{Disc{}, {}, {}, {}, 0}, {{Leaf{}}, {{0, {}}}, true}};
  twin.solid.round = true;
  return twin;
}

Twin plane() {
  Twin twin{{Plane{}, {}, {}, {}, 0}, {{Leaf{}}, {{0, {}}}, true}};
  twin.solid.endless = true;
  return twin;
}

Twin tapered_cylinder(double top_radius) {
  Leaf leaf;
  leaf.taper = Real(top_radius);
  return {{TaperedCylinder{top_radius}, {}, {}, {}, 0}, {{leaf}, {{0, {}}}, false}};
}

Twin polyhedron(const std::vector<HalfSpace>& planes) {
  Leaf leaf;
  leaf.planes = planes;
  for (HalfSpace& h : leaf.planes) {
    const double length = glm::length(h.normal);
    h.normal /= length;
    h.offset /= length;
  }
  return {{ConvexPolyhedron(planes), {}, {}, {}, 0}, {{leaf}, {{0, {}}}, false}};
}

Twin prism() {
  // Thesis, Table 1: the triangle (0, -2), (sqrt 3, 1), (-sqrt 3, 1) in xz, y from -1 to 1.
  const double h = std::numbers::sqrt3 / 2;
  return polyhedron(
      {{{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, 1}, {{-h, 0, -0.5}, 1}, {{h, 0, -0.5}, 1}});
}

Twin csg(const Piece& from) {
  return {{from.tree, {}, {}, {}, 0}, from.solid};
}

Piece piece(const Twin& convex) {
  const Transform& at = convex.placed.to_world;
  return std::visit(
      [&]<class S>(const S& solid) -> Piece {
        if constexpr (std::is_constructible_v<Convex, S>)
          return {{solid, at}, convex.solid};
        else
          throw std::logic_error("not convex");
      },
      convex.placed.shape);
}

Piece combined(CsgOperation operation, const Piece& left, const Piece& right) {
  Solid both = left.solid;
  const int shift = int(both.leaves.size());
  both.leaves.insert(both.leaves.end(), right.solid.leaves.begin(), right.solid.leaves.end());
  for (Step step : right.solid.steps) {
    if (step.leaf >= 0) step.leaf += shift;
    both.steps.push_back(step);
  }
  both.steps.push_back({-1, operation});
  return {{operation, left.tree, right.tree}, both};
}

Twin placed(Twin twin, const glm::dmat3& linear, const dvec3& offset) {
  twin.placed.to_world = Transform(linear, offset).after(twin.placed.to_world);
  twin.solid.move(linear, offset);
  return twin;
}

} // namespace abbe::reference
