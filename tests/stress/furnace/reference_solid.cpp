#include "tests/stress/furnace/reference_solid.h"

#include "tests/stress/furnace/meshes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

namespace abbe::stress {
namespace {

constexpr Real kInfinite = std::numeric_limits<Real>::infinity();
using Crossings = std::vector<SurfaceCrossing>;

/// The part of a line inside a convex solid, which shrinks as surfaces cut it.
struct Inside {
  SurfaceCrossing enter{-kInfinite, {}}, leave{kInfinite, {}};

  void cut(const Inside& other) {
    if (other.enter.t > enter.t) enter = other.enter;
    if (other.leave.t < leave.t) leave = other.leave;
  }
  void cut_to_nothing() { leave.t = -kInfinite; }
  /// Where normal . p <= offset.
  void cut_plane(const Line& line, const Vector& normal, Real offset) {
    const Real speed = glm::dot(normal, line.direction);
    const Real left = offset - glm::dot(normal, line.origin);
    if (speed == 0) {
      if (left < 0) cut_to_nothing();
    } else if (speed < 0) {
      cut({{left / speed, normal}, {kInfinite, {}}});
    } else {
      cut({{-kInfinite, {}}, {left / speed, normal}});
    }
  }
  [[nodiscard]] Crossings crossings() const {
    if (!(enter.t < leave.t)) return {};
    return {enter, leave};
  }
};

Crossings sphere(const Line& line, const Vector& middle, Real radius) {
  const Vector from = line.origin - middle;
  const Real a = glm::dot(line.direction, line.direction);
  const Real nearest = -glm::dot(from, line.direction) / a;
  const Vector foot = from + nearest * line.direction;
  const Real left = radius * radius - glm::dot(foot, foot);
  if (!(left > 0)) return {};
  const Real half = std::sqrt(left / a);
  const auto at = [&](Real t) { return SurfaceCrossing{t, line.at(t) - middle}; };
  return {at(nearest - half), at(nearest + half)};
}

/// x^2 + y^2 <= (1 + slope z)^2 and 0 <= z <= 1.
Crossings tapered(const Line& line, Real slope) {
  const Vector &o = line.origin, &d = line.direction;
  Inside inside;
  inside.cut_plane(line, {0, 0, -1}, 0);
  inside.cut_plane(line, {0, 0, 1}, 1);
  const Real radius = 1 + slope * o.z;
  const Real a = d.x * d.x + d.y * d.y - slope * slope * d.z * d.z;
  const Real b = o.x * d.x + o.y * d.y - slope * radius * d.z; // half of it
  const Real c = o.x * o.x + o.y * o.y - radius * radius;
  const Real square = b * b - a * c;
  if (!(square > 0)) {
    // The line crosses no side: it runs inside (the ends alone count) or misses the solid.
    if (a > 0 || c > 0) return {};
    return inside.crossings();
  }
  const Real root = std::sqrt(square);
  const Real q = b > 0 ? -b - root : -b + root;
  Real first = q / a, second = c / q;
  if (first > second) std::swap(first, second);
  const auto at = [&](Real t) {
    const Vector p = line.at(t);
    return SurfaceCrossing{t, {p.x, p.y, -slope * (1 + slope * p.z)}};
  };
  if (a > 0) {
    inside.cut({at(first), at(second)});
    return inside.crossings();
  }
  // Steeper than the side: it is inside before the first and behind the second, on one of the two
  // halves of the double cone. Only one of them lies between the ends.
  Inside before = inside, behind = inside;
  before.cut({{-kInfinite, {}}, at(first)});
  behind.cut({at(second), {kInfinite, {}}});
  Crossings found = before.crossings();
  const Crossings more = behind.crossings();
  found.insert(found.end(), more.begin(), more.end());
  return found;
}

Crossings planes(const Line& line, const std::vector<double>& numbers) {
  Inside inside;
  for (std::size_t i = 0; i < numbers.size(); i += 4)
    inside.cut_plane(line, {numbers[i], numbers[i + 1], numbers[i + 2]}, numbers[i + 3]);
  return inside.crossings();
}

Crossings prism(const Line& line) {
  const Real root3 = std::numbers::sqrt3_v<Real>;
  Inside inside;
  inside.cut_plane(line, {0, 1, 0}, 1);
  inside.cut_plane(line, {0, -1, 0}, 1);
  inside.cut_plane(line, {0, 0, 1}, 1);
  inside.cut_plane(line, {root3, 0, -1}, 2); // through (0, -2) and (root 3, 1)
  inside.cut_plane(line, {-root3, 0, -1}, 2);
  return inside.crossings();
}

Crossings mesh(const Line& line, const std::string& file) {
  static std::map<std::string, Triangles> known;
  const auto [found, is_new] = known.try_emplace(file);
  if (is_new) found->second = named_mesh(std::filesystem::path(file).stem().string());
  const Triangles& triangles = found->second;
  const auto vertex = [&](int i) {
    const auto& v = triangles.vertices[static_cast<std::size_t>(i)];
    return Vector(v[0], v[1], v[2]);
  };
  Crossings all;
  for (const auto& [a, b, c] : triangles.faces) {
    const Vector corner = vertex(a), u = vertex(b) - corner, v = vertex(c) - corner;
    const Vector normal = glm::cross(u, v);
    const Real speed = glm::dot(normal, line.direction);
    if (speed == 0) continue;
    const Real t = glm::dot(normal, corner - line.origin) / speed;
    const Vector p = line.at(t) - corner;
    const Real along_u = glm::dot(glm::cross(p, v), normal),
               along_v = glm::dot(glm::cross(u, p), normal);
    if (along_u >= 0 && along_v >= 0 && along_u + along_v <= glm::dot(normal, normal))
      all.push_back({t, normal});
  }
  std::sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.t < y.t; });
  if (all.size() % 2 != 0) all.clear(); // through an edge: no ray in a million
  return all;
}

/// What a boolean leaves of two solids.
Crossings combined(Solid::Kind kind, const Crossings& first, const Crossings& second) {
  const auto holds = [&](bool a, bool b) {
    if (kind == Solid::Kind::set_union) return a || b;
    return kind == Solid::Kind::intersection ? a && b : a && !b;
  };
  Crossings result;
  std::size_t i = 0, j = 0;
  while (i < first.size() || j < second.size()) {
    const bool was = holds(i % 2 != 0, j % 2 != 0);
    const Real t = std::min(i < first.size() ? first[i].t : kInfinite,
                            j < second.size() ? second[j].t : kInfinite);
    // Faces that coincide are crossed together.
    const auto here = [&](const Crossings& list, std::size_t k) {
      return k < list.size() && list[k].t <= t + 1e-12L;
    };
    SurfaceCrossing crossing{t, {}};
    while (here(first, i))
      crossing.normal = first[i++].normal;
    while (here(second, j))
      crossing.normal = second[j++].normal * Real(kind == Solid::Kind::difference ? -1 : 1);
    if (holds(i % 2 != 0, j % 2 != 0) != was) result.push_back(crossing);
  }
  return result;
}

/// A lens by its meaning: the cylinder about the axis between the two surfaces. Each surface is the
/// side of a ball that is turned to its vertex, or a plane.
Crossings lens_element(const Line& line, const std::vector<double>& numbers) {
  const Real half = Real(numbers[3]) / 2, thickness = numbers[2];
  // The round side, of which ends far away show nothing.
  Line flat = line;
  flat.origin.z = flat.direction.z = 0;
  const Real a = glm::dot(flat.direction, flat.direction),
             b = glm::dot(flat.origin, flat.direction);
  const Real square = b * b - a * (glm::dot(flat.origin, flat.origin) - half * half);
  if (!(square > 0)) return {};
  const auto side = [&](Real t) { return SurfaceCrossing{t, flat.at(t)}; };
  Crossings glass{side((-b - std::sqrt(square)) / a), side((-b + std::sqrt(square)) / a)};
  const auto grind = [&](Real radius, Real vertex, Real outwards) {
    if (radius == 0) {
      Inside plane;
      plane.cut_plane(line, {0, 0, outwards}, outwards * vertex);
      glass = combined(Solid::Kind::intersection, glass, plane.crossings());
      return;
    }
    const bool convex = radius * outwards < 0;
    const Crossings ball = sphere(line, {0, 0, vertex + radius}, std::abs(radius));
    if (convex) {
      glass = combined(Solid::Kind::intersection, glass, ball);
      return;
    }
    // A hollow surface is that half of its ball that is turned to the glass; all that lies farther
    // out is taken away with it.
    Inside beyond;
    beyond.cut_plane(line, {0, 0, -outwards}, -outwards * (vertex + radius));
    glass = combined(Solid::Kind::difference, glass, ball);
    glass = combined(Solid::Kind::difference, glass, beyond.crossings());
  };
  grind(numbers[0], 0, -1);
  grind(numbers[1], thickness, 1);
  return glass;
}

Crossings of_shape(const Solid& solid, const Line& line) {
  using enum Solid::Kind;
  switch (solid.kind) {
  case sphere:
    return stress::sphere(line, Vector(0), 1);
  case cube:
    return stress::planes(
        line, {1, 0, 0, 1, -1, 0, 0, 1, 0, 1, 0, 1, 0, -1, 0, 1, 0, 0, 1, 1, 0, 0, -1, 1});
  case prism:
    return stress::prism(line);
  case cylinder:
    return tapered(line, 0);
  case cone:
    return tapered(line, -1);
  case tapered_cylinder:
    return tapered(line, Real(solid.numbers[0]) - 1);
  case planes:
    return stress::planes(line, solid.numbers);
  case lens_element:
    return stress::lens_element(line, solid.numbers);
  case mesh:
    return stress::mesh(line, solid.names[0]);
  case set_union:
  case intersection:
  case difference:
    return combined(solid.kind, crossings(solid.operands[0], line),
                    crossings(solid.operands[1], line));
  case square:
  case disc: {
    if (line.direction.z == 0) return {};
    const Real t = -line.origin.z / line.direction.z;
    const Vector p = line.at(t);
    const bool holds =
        solid.kind == disc ? p.x * p.x + p.y * p.y <= 1 : std::abs(p.x) <= 1 && std::abs(p.y) <= 1;
    if (!holds) return {};
    return {{t, {0, 0, 1}}};
  }
  case cemented:
    break; // not among lossy scenes
  }
  return {};
}

/// Rodrigues' rotation of v about a unit axis.
Vector rotated(const Vector& v, const Vector& axis, Real angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
}

/// A statement undone; `transposed` undoes it for normals, from the inside out.
Vector undone(const Placing& placing, const Vector& v, bool is_point) {
  const Vector values(placing.values[0], placing.values[1], placing.values[2]);
  switch (placing.kind) {
  case Placing::Kind::translate:
    return is_point ? v - values : v;
  case Placing::Kind::scale:
    return v / values;
  case Placing::Kind::rotate:
    break;
  }
  const Vector axis =
      glm::normalize(Vector(placing.values[1], placing.values[2], placing.values[3]));
  return rotated(v, axis, -std::numbers::pi_v<Real> * Real(placing.values[0]) / 180);
}

/// What a statement makes of a normal.
Vector placed_normal(const Placing& placing, const Vector& n) {
  switch (placing.kind) {
  case Placing::Kind::translate:
    return n;
  case Placing::Kind::scale:
    return n / Vector(placing.values[0], placing.values[1], placing.values[2]);
  case Placing::Kind::rotate:
    break;
  }
  const Vector axis =
      glm::normalize(Vector(placing.values[1], placing.values[2], placing.values[3]));
  return rotated(n, axis, std::numbers::pi_v<Real> * Real(placing.values[0]) / 180);
}

} // namespace

std::vector<SurfaceCrossing> crossings(const Solid& solid, const Line& line) {
  Line local = line; // t stays as it is: directions are not made unit
  for (const Placing& placing : solid.placing) {
    local.origin = undone(placing, local.origin, true);
    local.direction = undone(placing, local.direction, false);
  }
  Crossings found = of_shape(solid, local);
  for (SurfaceCrossing& crossing : found) {
    for (auto placing = solid.placing.rbegin(); placing != solid.placing.rend(); ++placing)
      crossing.normal = placed_normal(*placing, crossing.normal);
    crossing.normal = glm::normalize(crossing.normal);
  }
  return found;
}

} // namespace abbe::stress
