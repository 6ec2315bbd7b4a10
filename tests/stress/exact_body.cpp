#include "tests/stress/exact_body.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abbe::stress {
namespace {

constexpr Real kInf = std::numeric_limits<Real>::infinity();

Real largest(const Vec& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The largest sum of magnitudes of a row.
Real row_norm(const Mat& m) {
  Real found = 0;
  for (int row = 0; row < 3; ++row)
    found = std::max(found, std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row]));
  return found;
}

void ball_stretch(const Vec& o, const Vec& d, ExactCrossing& first, ExactCrossing& last) {
  const Real speed = glm::length(d);
  const Vec u = d / speed;
  const Real along = glm::dot(o, u);
  const Vec nearest = o - along * u;
  const Real square = 1 - glm::dot(nearest, nearest);
  if (square < 0) return;
  const Real half = std::sqrt(square);
  first = {(-along - half) / speed, true, {}};
  last = {(-along + half) / speed, false, {}};
}

/// Cuts the stretch by the half-space n.p <= offset.
void cut(const Vec& n, Real offset, int face, const Vec& o, const Vec& d, ExactCrossing& first,
         ExactCrossing& last) {
  const Real speed = glm::dot(n, d), height = glm::dot(n, o) - offset;
  if (speed == 0) {
    if (height > 0) last.t = -kInf;
    return;
  }
  const Real t = -height / speed;
  if (speed < 0 && t > first.t) first = {t, true, {0, face}};
  if (speed > 0 && t < last.t) last = {t, false, {0, face}};
}

/// The side of x^2 + y^2 = (1 + k z)^2, seen from the point of the line nearest to the middle.
void side_stretch(Real k, const Vec& from, const Vec& d, ExactCrossing& first,
                  ExactCrossing& last) {
  const Real shift = -glm::dot(from - Vec(0, 0, 0.5L), d) / glm::dot(d, d);
  const Vec o = from + shift * d;
  const Real r = 1 + k * o.z, dr = k * d.z;
  const Real speed = std::hypot(d.x, d.y);
  const Real a = (speed - std::abs(dr)) * (speed + std::abs(dr));
  const Real b = o.x * d.x + o.y * d.y - r * dr;
  const Real rho = std::hypot(o.x, o.y);
  const Real c = (rho - r) * (rho + r);
  const Real w_x = r * d.x - dr * o.x, w_y = r * d.y - dr * o.y, moment = o.x * d.y - o.y * d.x;
  const Real w = std::hypot(w_x, w_y);
  const Real square = (w - std::abs(moment)) * (w + std::abs(moment));
  if (a == 0 && b == 0) {
    if (c > 0) last.t = -kInf;
    return;
  }
  const auto begins = [&](Real t) {
    if (t + shift > first.t) first = {t + shift, true, {}};
  };
  const auto ends = [&](Real t) {
    if (t + shift < last.t) last = {t + shift, false, {}};
  };
  if (a == 0) { // along a line of the cone
    if (b > 0)
      ends(-c / (2 * b));
    else
      begins(-c / (2 * b));
    return;
  }
  if (square < 0 && a > 0) {
    last.t = -kInf;
    return;
  }
  const Real root = std::sqrt(std::max(Real(0), square));
  const Real q = b > 0 ? -b - root : -b + root;
  Real near = q / a, far = q != 0 ? c / q : near;
  if (near > far) std::swap(near, far);
  if (a < 0) { // inside both nappes, outside between them
    if (dr > 0)
      begins(far);
    else
      ends(near);
    return;
  }
  if (r + dr * (near + far) / 2 < 0) {
    last.t = -kInf;
    return;
  }
  begins(near);
  ends(far);
}

} // namespace

ExactLeaf::ExactLeaf(Kind form, const Transform& to_world)
    : kind(form), inverse(glm::inverse(Mat(to_world.linear()))), offset(to_world.offset()),
      norm(row_norm(Mat(to_world.linear()))), condition(norm * row_norm(inverse)) {}

bool ExactLeaf::contains(const Vec& world) const {
  const Vec p = seen(world);
  switch (kind) {
  case Kind::ball:
    return glm::dot(p, p) < 1;
  case Kind::planes:
    return std::all_of(planes.begin(), planes.end(),
                       [&](const auto& h) { return glm::dot(h.first, p) < h.second; });
  case Kind::taper:
    return p.z > 0 && p.z < 1 && std::hypot(p.x, p.y) < 1 + (top_radius - 1) * p.z;
  case Kind::square:
  case Kind::disc:
  case Kind::endless:
    break;
  }
  return false;
}

void ExactLeaf::stretch(const Vec& origin, const Vec& direction, ExactCrossing& first,
                        ExactCrossing& last) const {
  const Vec o = seen(origin), d = inverse * direction;
  first = {kInf, true, {}};
  last = {-kInf, false, {}};
  if (kind == Kind::ball) {
    ball_stretch(o, d, first, last);
    return;
  }
  first.t = -kInf;
  last.t = kInf;
  for (std::size_t i = 0; i < planes.size(); ++i)
    cut(planes[i].first, planes[i].second, static_cast<int>(i), o, d, first, last);
  if (kind == Kind::taper) {
    cut(Vec(0, 0, -1), 0, 1, o, d, first, last);
    cut(Vec(0, 0, 1), 1, 2, o, d, first, last);
    side_stretch(top_radius - 1, o, d, first, last);
  }
}

Real ExactLeaf::height(int face, const Vec& world) const {
  const Vec p = seen(world);
  const auto away = [&](Real level, const Vec& gradient) {
    return level / glm::length(gradient * inverse);
  };
  if (kind == Kind::ball) {
    const Real r = glm::length(p);
    return r == 0 ? -kInf : away(r - 1, p / r);
  }
  if (kind == Kind::planes) {
    const auto& [n, height] = planes[static_cast<std::size_t>(face)];
    return away(glm::dot(n, p) - height, n);
  }
  if (kind == Kind::taper && face == 0) {
    const Real rho = std::hypot(p.x, p.y), k = top_radius - 1;
    return away(rho - 1 - k * p.z, rho == 0 ? Vec(0, 0, 1) : Vec(p.x / rho, p.y / rho, -k));
  }
  if (kind == Kind::taper && face == 1) return away(-p.z, Vec(0, 0, 1));
  return away(p.z - (face == 2 ? 1 : 0), Vec(0, 0, 1));
}

Real ExactLeaf::distance(int face, const Vec& world) const {
  return std::abs(height(face, world));
}

int ExactLeaf::faces() const {
  if (kind == Kind::planes) return static_cast<int>(planes.size());
  return kind == Kind::taper ? 3 : 1;
}

Real ExactLeaf::clearance(const Vec& world) const {
  Real smallest = kInf;
  for (int face = 0; face < faces(); ++face)
    smallest = std::min(smallest, distance(face, world));
  return smallest;
}

bool ExactLeaf::may_show(int face, const Vec& world, Real moved) const {
  for (int other = 0; other < faces(); ++other)
    if (other != face && height(other, world) > moved) return false;
  return true;
}

Vec ExactLeaf::normal(int face, const Vec& world) const {
  const Vec p = seen(world);
  Vec n(0, 0, face == 1 ? -1 : 1);
  if (kind == Kind::ball) n = p;
  if (kind == Kind::planes) n = planes[static_cast<std::size_t>(face)].first;
  if (kind == Kind::taper && face == 0) n = {p.x, p.y, (1 - top_radius) * std::hypot(p.x, p.y)};
  return glm::normalize(n * inverse);
}

Real ExactLeaf::turn(int face, const Vec& world, Real shift) const {
  if (kind == Kind::ball) return 2 * shift * condition * row_norm(inverse);
  if (kind != Kind::taper || face != 0) return 0;
  const Vec p = seen(world);
  return 2 * shift * condition * row_norm(inverse) / std::hypot(p.x, p.y);
}

ExactBody::ExactBody(const PlacedShape& placed) {
  using Kind = ExactLeaf::Kind;
  const auto leaf_of = [&]<class S>(const S& shape, const Transform& at) {
    if constexpr (std::is_same_v<S, Box>) {
      ExactLeaf leaf(Kind::planes, at);
      for (int axis = 0; axis < 3; ++axis)
        for (const Real sign : {-1, 1}) {
          Vec n(0);
          n[axis] = sign;
          leaf.planes.emplace_back(n, 1);
        }
      return leaf;
    } else if constexpr (std::is_same_v<S, ConvexPolyhedron>) {
      ExactLeaf leaf(Kind::planes, at);
      for (const HalfSpace& h : shape.half_spaces()) {
        leaf.planes.emplace_back(h.normal, h.offset);
        leaf.size = std::max(leaf.size, std::abs(Real(h.offset)));
      }
      for (const dvec3& v : shape.vertices())
        leaf.size = std::max(leaf.size, largest(Vec(v)));
      return leaf;
    } else if constexpr (std::is_same_v<S, TaperedCylinder>) {
      ExactLeaf leaf(Kind::taper, at);
      leaf.top_radius = shape.top_radius;
      leaf.size = 2 + leaf.top_radius;
      return leaf;
    } else {
      return ExactLeaf(std::is_same_v<S, Square>  ? Kind::square
                       : std::is_same_v<S, Disc>  ? Kind::disc
                       : std::is_same_v<S, Plane> ? Kind::endless
                                                  : Kind::ball,
                       at);
    }
  };
  const Transform& to_world = placed.to_world;
  solid_ = is_solid(placed.shape);
  if (const auto* mesh = std::get_if<Mesh>(&placed.shape)) {
    const Mat linear(to_world.linear());
    for (const dvec3& v : mesh->vertices())
      vertices_.push_back(linear * Vec(v) + Vec(to_world.offset()));
    triangles_ = mesh->triangles();
    const Real mirrored = glm::determinant(linear) < 0 ? -1 : 1;
    for (const Triangle& t : triangles_) {
      const auto corner = [&](std::size_t i) { return vertices_[static_cast<std::size_t>(t[i])]; };
      normals_.push_back(mirrored *
                         glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
    }
    mesh_condition_ = row_norm(linear) * row_norm(glm::inverse(linear));
    mesh_size_ = largest(Vec(to_world.offset())) + row_norm(linear) * Real(mesh->size());
    return;
  }
  std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (std::is_same_v<S, CsgTree>) {
          steps_ = shape.steps();
          for (const CsgLeaf& leaf : shape.leaves()) {
            flipped_.push_back(leaf.flipped);
            leaves_.push_back(std::visit(
                [&](const auto& convex) { return leaf_of(convex, to_world.after(leaf.to_tree)); },
                leaf.solid));
          }
        } else if constexpr (!std::is_same_v<S, Mesh>) {
          leaves_.push_back(leaf_of(shape, to_world));
          flipped_.push_back(false);
        }
      },
      placed.shape);
}

bool ExactBody::combine(const std::vector<bool>& in_leaf) const {
  if (steps_.empty()) return in_leaf[0];
  std::array<bool, 64> stack{};
  std::size_t top = 0;
  for (const CsgTree::Step& step : steps_) {
    if (step.leaf >= 0) {
      stack[top++] = in_leaf[static_cast<std::size_t>(step.leaf)];
      continue;
    }
    const bool b = stack[--top], a = stack[top - 1];
    stack[top - 1] = step.operation == CsgOperation::unite       ? a || b
                     : step.operation == CsgOperation::intersect ? a && b
                                                                 : a && !b;
  }
  return stack[0];
}

bool ExactBody::may_show(FaceId face, const Vec& world, Real moved) const {
  if (!triangles_.empty()) {
    const auto i = static_cast<std::size_t>(face.face);
    return comes_near(i, world, moved);
  }
  const auto leaf = static_cast<std::size_t>(face.leaf);
  if (!leaves_[leaf].may_show(face.face, world, moved)) return false;
  if (steps_.empty()) return true;
  // The face shows where the solid is on one side of it alone; leaves with a surface that close may
  // hold the place or not.
  std::vector<bool> in;
  std::vector<std::size_t> unsure;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    in.push_back(leaves_[i].contains(world));
    if (i != leaf && leaves_[i].clearance(world) <= moved) unsure.push_back(i);
  }
  for (std::size_t choice = 0; choice < std::size_t{1} << unsure.size(); ++choice) {
    for (std::size_t k = 0; k < unsure.size(); ++k)
      in[unsure[k]] = (choice >> k & 1) != 0;
    in[leaf] = true;
    const bool with = combine(in);
    in[leaf] = false;
    if (with != combine(in)) return true;
  }
  return false;
}

bool ExactBody::contains(const Vec& world) const {
  if (!solid_) return false;
  if (!triangles_.empty()) {
    thread_local std::vector<ExactCrossing> found;
    found.clear();
    mesh_crossings(world, Vec(0.3577712L, 0.5291503L, 0.7694421L), found);
    return std::count_if(found.begin(), found.end(), [](const auto& c) { return c.t > 0; }) % 2 !=
           0;
  }
  thread_local std::vector<bool> in;
  in.clear();
  for (const ExactLeaf& leaf : leaves_)
    in.push_back(leaf.contains(world));
  return combine(in);
}

void ExactBody::mesh_crossings(const Vec& origin, const Vec& direction,
                               std::vector<ExactCrossing>& found) const {
  // In a plane across the line a triangle is met where the three edges have the origin on one
  // side. An edge's sign is computed alike for both of its triangles.
  int z = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(direction[i]) > std::abs(direction[z])) z = i;
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const Real shear_x = direction[x] / direction[z], shear_y = direction[y] / direction[z];
  thread_local std::vector<std::array<Real, 2>> seen;
  seen.clear();
  for (const Vec& v : vertices_) {
    const Vec p = v - origin;
    seen.push_back({p[x] - shear_x * p[z], p[y] - shear_y * p[z]});
  }
  const auto side = [&](std::int32_t from, std::int32_t to) {
    const auto& p = seen[static_cast<std::size_t>(std::min(from, to))];
    const auto& q = seen[static_cast<std::size_t>(std::max(from, to))];
    const bool left = p[0] * q[1] - p[1] * q[0] >= 0;
    return left == (from < to);
  };
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Triangle& t = triangles_[i];
    const bool a = side(t[0], t[1]);
    if (a != side(t[1], t[2]) || a != side(t[2], t[0])) continue;
    const Real speed = glm::dot(normals_[i], direction);
    if (speed == 0) continue;
    const Vec& corner = vertices_[static_cast<std::size_t>(t[0])];
    found.push_back({glm::dot(normals_[i], corner - origin) / speed,
                     speed < 0,
                     {0, static_cast<std::int32_t>(i)}});
  }
}

void ExactBody::crossings(const Vec& origin, const Vec& direction,
                          std::vector<ExactCrossing>& found) const {
  const auto by_t = [](const ExactCrossing& a, const ExactCrossing& b) { return a.t < b.t; };
  const std::size_t begin = found.size();
  if (!triangles_.empty()) {
    mesh_crossings(origin, direction, found);
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(), by_t);
    return;
  }
  if (!solid_) {
    const ExactLeaf& leaf = leaves_[0];
    const Vec o = leaf.seen(origin), d = leaf.inverse * direction;
    if (d.z == 0) return;
    const Real t = -o.z / d.z;
    if (inside_rim(origin + t * direction) >= 0) found.push_back({t, d.z < 0, {}});
    return;
  }
  thread_local std::vector<ExactCrossing> ends; // two for each leaf
  ends.clear();
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    ExactCrossing first, last;
    leaves_[i].stretch(origin, direction, first, last);
    if (!(first.t < last.t)) continue;
    first.face.leaf = last.face.leaf = static_cast<std::int32_t>(i);
    ends.push_back(first);
    ends.push_back(last);
  }
  if (leaves_.size() == 1) {
    found.insert(found.end(), ends.begin(), ends.end());
    return;
  }
  std::stable_sort(ends.begin(), ends.end(), by_t);
  thread_local std::vector<bool> in;
  in.assign(leaves_.size(), false);
  bool inside = false;
  for (const ExactCrossing& c : ends) {
    in[static_cast<std::size_t>(c.face.leaf)] = c.entering;
    const bool now = combine(in);
    if (now == inside) continue;
    inside = now;
    found.push_back({c.t, now, c.face});
  }
}

Real ExactBody::blur(const Vec& origin, Real t) const {
  constexpr Real kUnit = 0x1p-53L;
  const Real reach = largest(origin) + std::abs(t);
  if (!triangles_.empty()) return 32 * kUnit * mesh_condition_ * (reach + mesh_size_);
  Real found = 0;
  for (const ExactLeaf& leaf : leaves_)
    found = std::max(found, 32 * kUnit * leaf.condition *
                                (reach + largest(leaf.offset) + leaf.size * leaf.norm));
  return found;
}

bool ExactBody::comes_near(std::size_t triangle, const Vec& world, Real distance) const {
  const Triangle& t = triangles_[triangle];
  const auto corner = [&](std::size_t k) { return vertices_[static_cast<std::size_t>(t[k])]; };
  const Vec n = normals_[triangle];
  if (std::abs(glm::dot(n, world - corner(0))) > distance) return false;
  for (std::size_t k = 0; k < 3; ++k) { // outside of an edge, in the triangle's plane
    const Vec edge = corner((k + 1) % 3) - corner(k);
    const Vec outwards = glm::normalize(glm::cross(edge, n));
    const Real out = glm::dot(outwards, world - corner(k));
    const Real opposite = glm::dot(outwards, corner((k + 2) % 3) - corner(k));
    if ((opposite < 0 ? out : -out) > distance) return false;
  }
  return true;
}

bool ExactBody::comes_near(const Vec& world, Real distance) const {
  if (!solid_) return false;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (comes_near(i, world, distance)) return true;
  for (const ExactLeaf& leaf : leaves_)
    if (leaf.clearance(world) <= distance) return true;
  return false;
}

Real ExactBody::inside_rim(const Vec& world) const {
  const ExactLeaf& leaf = leaves_[0];
  if (leaf.kind == ExactLeaf::Kind::endless) return kInf;
  const Vec p = leaf.seen(world);
  const Real inside = leaf.kind == ExactLeaf::Kind::disc
                          ? 1 - std::hypot(p.x, p.y)
                          : 1 - std::max(std::abs(p.x), std::abs(p.y));
  return inside / row_norm(leaf.inverse); // no farther than that
}

Real ExactBody::distance(FaceId face, const Vec& world) const {
  if (triangles_.empty())
    return leaves_[static_cast<std::size_t>(face.leaf)].distance(face.face, world);
  const auto i = static_cast<std::size_t>(face.face);
  return std::abs(
      glm::dot(normals_[i], world - vertices_[static_cast<std::size_t>(triangles_[i][0])]));
}

Vec ExactBody::normal(FaceId face, const Vec& world) const {
  if (!triangles_.empty()) return normals_[static_cast<std::size_t>(face.face)];
  const auto leaf = static_cast<std::size_t>(face.leaf);
  const Vec n = leaves_[leaf].normal(face.face, world);
  return flipped_[leaf] ? -n : n;
}

Real ExactBody::turn(FaceId face, const Vec& world, Real shift) const {
  if (!triangles_.empty()) return 0;
  return leaves_[static_cast<std::size_t>(face.leaf)].turn(face.face, world, shift);
}

} // namespace abbe::stress
