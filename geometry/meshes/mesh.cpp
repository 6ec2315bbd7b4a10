#include "geometry/meshes/mesh.h"

#include "geometry/meshes/edge_table.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

/// Numbers places; equal places get the same number.
class Places {
public:
  Places(std::vector<dvec3>& vertices, std::size_t most)
      : vertices_(vertices), table_(std::bit_ceil(2 * most + 1), -1) {}

  /// Adds the place to the vertices unless it is there.
  std::int32_t number(const dvec3& p) {
    const std::size_t last = table_.size() - 1;
    std::size_t place = hash(p) & last;
    while (table_[place] >= 0 && vertices_[static_cast<std::size_t>(table_[place])] != p)
      place = (place + 1) & last;
    if (table_[place] < 0) {
      table_[place] = static_cast<std::int32_t>(vertices_.size());
      vertices_.push_back(p);
    }
    return table_[place];
  }

private:
  static std::size_t hash(const dvec3& p) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) { // the 0 makes -0 a 0; the factor is an odd number near 2^64 / phi
      h = (h ^ std::bit_cast<std::uint64_t>(p[i] + 0.0)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }

  std::vector<dvec3>& vertices_;
  std::vector<std::int32_t> table_; ///< open addressing; a negative number is an empty place
};

/// Numbers the vertices in the order in which the triangles name them; those that are not named
/// are left out.
void sort_vertices(std::vector<dvec3>& vertices, std::vector<Triangle>& triangles) {
  std::vector<std::int32_t> number(vertices.size(), -1);
  std::vector<dvec3> sorted;
  sorted.reserve(vertices.size());
  for (Triangle& t : triangles)
    for (std::int32_t& corner : t) {
      const auto old = static_cast<std::size_t>(corner);
      if (number[old] < 0) {
        number[old] = static_cast<std::int32_t>(sorted.size());
        sorted.push_back(vertices[old]);
      }
      corner = number[old];
    }
  sorted.shrink_to_fit();
  vertices = std::move(sorted);
}

/// The angle under which a triangle is seen, counter-clockwise above 0 [OS83].
double solid_angle(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  return 2.0 *
         std::atan2(glm::dot(a, glm::cross(b, c)),
                    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

double squared(const dvec3& v) {
  return glm::dot(v, v);
}

/// The squared distance from the origin to a triangle: to its plane above it, else to its edges.
double squared_distance(const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 n = glm::cross(b - a, c - a);
  const auto above = [&](const dvec3& p, const dvec3& q) {
    return glm::dot(glm::cross(q - p, -p), n) >= 0.0;
  };
  if (above(a, b) && above(b, c) && above(c, a)) return std::pow(glm::dot(n, a), 2) / squared(n);
  const auto to_edge = [](const dvec3& p, const dvec3& q) {
    const double along = std::clamp(-glm::dot(p, q - p) / squared(q - p), 0.0, 1.0);
    return squared(p + along * (q - p));
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

double squared_distance(const Bounds& box, const dvec3& point) {
  return squared(glm::max(glm::max(box.lower - point, point - box.upper), dvec3(0.0)));
}

/// Searches the hierarchy for the triangle by which a ray from a point leaves where it is moved
/// least: to the triangle, and where the ray runs in from it, by as much as it comes below it.
class NearestFace {
public:
  NearestFace(const Mesh& mesh, const dvec3& point, const dvec3& direction)
      : mesh_(mesh), ray_{point, direction} {
    visit(0);
  }
  [[nodiscard]] NearFace found() const { return {face_, std::sqrt(smallest_)}; }

private:
  void visit(std::int32_t child) {
    if (MeshLeaf::is(child)) return ask(MeshLeaf::of(child));
    const MeshNode& node = mesh_.hierarchy().nodes[static_cast<std::size_t>(child)];
    std::vector<std::pair<double, std::int32_t>> boxes;
    for (std::size_t i = 0; i < 8; ++i)
      if (node.holds(i))
        boxes.emplace_back(squared_distance(mesh_.hierarchy().bounds(node, i), ray_.origin),
                           node.child[i]);
    std::sort(boxes.begin(), boxes.end());
    for (const auto& [distance, box] : boxes)
      if (distance < smallest_) visit(box);
  }
  void ask(const MeshLeaf& leaf) {
    for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const auto [a, b, c] = mesh_.corners(i);
      const dvec3& o = ray_.origin;
      double move = squared_distance(a - o, b - o, c - o);
      if (move >= smallest_) continue;
      if (runs_in(outward_normal(mesh_, o, i), ray_.direction))
        move = std::pow(std::sqrt(move) + depth_below(mesh_, ray_, i), 2);
      if (move >= smallest_) continue;
      smallest_ = move;
      face_ = i;
    }
  }

  const Mesh& mesh_;
  LocalRay ray_;
  double smallest_ = kInfinity;
  int face_ = 0;
};

/// The box around what a box of a node holds: its triangles, or after `levels` more nodes the boxes
/// themselves, which are looser.
Bounds placed_bounds(const Mesh& mesh, const Transform& to_world, const MeshNode& node,
                     int levels) {
  Bounds found;
  for (std::size_t i = 0; i < 8; ++i) {
    if (!node.holds(i)) continue;
    if (MeshLeaf::is(node.child[i])) {
      const MeshLeaf leaf = MeshLeaf::of(node.child[i]);
      for (int t = leaf.first; t < leaf.first + leaf.count; ++t)
        for (int c = 0; c < 3; ++c) {
          const dvec3 p = to_world.point(mesh.corner(t, c));
          found = found.joined({p, p});
        }
    } else if (levels > 0) {
      const MeshNode& inner = mesh.hierarchy().nodes[static_cast<std::size_t>(node.child[i])];
      found = found.joined(placed_bounds(mesh, to_world, inner, levels - 1));
    } else {
      found = found.joined(to_world.box(mesh.hierarchy().bounds(node, i)));
    }
  }
  return found;
}

template <class T>
std::size_t bytes(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

} // namespace

Mesh::Mesh(const std::vector<dvec3>& vertices, const std::vector<Triangle>& triangles) {
  auto data = std::make_shared<Data>();
  Places places(data->vertices, vertices.size());
  std::vector<std::int32_t> merged;
  merged.reserve(vertices.size());
  for (const dvec3& p : vertices) {
    if (!std::isfinite(p.x + p.y + p.z))
      throw std::invalid_argument("a vertex has a coordinate that is no finite number");
    merged.push_back(places.number(p));
  }
  data->triangles.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    Triangle found{};
    std::array<dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < 0 || static_cast<std::size_t>(t[i]) >= merged.size())
        throw std::invalid_argument("a triangle has a corner that is no vertex");
      found[i] = merged[static_cast<std::size_t>(t[i])];
      p[i] = vertices[static_cast<std::size_t>(t[i])];
    }
    if (squared(glm::cross(p[1] - p[0], p[2] - p[0])) > 0.0) data->triangles.push_back(found);
  }
  if (data->triangles.empty()) throw std::invalid_argument("there is no triangle with an area");
  data->triangles.shrink_to_fit();
  data->closed = are_closed(data->vertices.size(), data->triangles);
  data->hierarchy = make_hierarchy(data->vertices, data->triangles);
  sort_vertices(data->vertices, data->triangles);
  for (const dvec3& p : data->vertices)
    data->size = std::max({data->size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  double volume = 0.0; // six times that of the tetrahedra with a corner at the first vertex
  const dvec3& first = data->vertices[0];
  for (const Triangle& t : data->triangles) {
    const auto at = [&](std::size_t i) {
      return data->vertices[static_cast<std::size_t>(t[i])] - first;
    };
    volume += glm::dot(at(0), glm::cross(at(1), at(2)));
    data->area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
  }
  if (data->closed && volume < 0.0)
    for (Triangle& t : data->triangles)
      std::swap(t[1], t[2]);
  data_ = std::move(data);
}

std::size_t Mesh::memory() const {
  return sizeof(Data) + bytes(data_->vertices) + bytes(data_->triangles) +
         bytes(data_->hierarchy.nodes) +
         (normals_ ? bytes(normals_->normals) + bytes(normals_->of_triangles) : 0);
}

dvec3 outward_normal(const Mesh& mesh, const dvec3&, int face) {
  const dvec3& a = mesh.corner(face, 0);
  return glm::normalize(glm::cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
}

Mesh Mesh::shaded_by(CornerNormals normals) const {
  if (normals.of_triangles.size() != triangles().size())
    throw std::invalid_argument("there is not one row of normals for each triangle");
  Mesh shaded = *this;
  shaded.normals_ = std::make_shared<const CornerNormals>(std::move(normals));
  return shaded;
}

/// The share of each corner is the area of the triangle that the point makes with the others.
std::optional<dvec3> shading_normal(const Mesh& mesh, const dvec3& point, int face) {
  const CornerNormals* all = mesh.corner_normals();
  if (!all) return std::nullopt;
  const Triangle& own = all->of_triangles[static_cast<std::size_t>(face)];
  if (own[0] < 0) return std::nullopt;
  const auto [a, b, c] = mesh.corners(face);
  const dvec3 across = glm::cross(b - a, c - a);
  const double u = std::max(0.0, glm::dot(glm::cross(c - b, point - b), across));
  const double v = std::max(0.0, glm::dot(glm::cross(a - c, point - c), across));
  const double w = std::max(0.0, glm::dot(glm::cross(b - a, point - a), across));
  const auto normal = [&](std::size_t i) {
    return dvec3(all->normals[static_cast<std::size_t>(own[i])]);
  };
  const dvec3 sum = u * normal(0) + v * normal(1) + w * normal(2);
  const double outwards = glm::dot(sum, across), length = glm::length(sum);
  if (!(outwards != 0.0 && std::isfinite(1.0 / length))) return std::nullopt;
  return sum / (outwards > 0.0 ? length : -length);
}

dvec3 snapped(const Mesh& mesh, const dvec3& point, int face) {
  const dvec3 n = outward_normal(mesh, point, face);
  return point - glm::dot(n, point - mesh.corner(face, 0)) * n;
}

NearFace nearest_face(const Mesh& mesh, const LocalRay& ray, bool entering) {
  return NearestFace(mesh, ray.origin, entering ? -ray.direction : ray.direction).found();
}

double depth_below(const Mesh& mesh, const LocalRay& ray, int face) {
  double reach = 0.0;
  for (const dvec3& corner : mesh.corners(face))
    reach = std::max(reach, glm::length(corner - ray.origin));
  return reach * std::abs(glm::dot(outward_normal(mesh, ray.origin, face), ray.direction)) /
         glm::length(ray.direction);
}

double signed_distance(const Mesh& mesh, const dvec3& point) {
  if (!mesh.is_closed()) return 1.0;
  // The boxes hold the triangles, and between them there may be room inside the mesh.
  const MeshHierarchy& boxes = mesh.hierarchy();
  Bounds all;
  for (std::size_t i = 0; i < 8; ++i)
    if (boxes.nodes[0].holds(i)) all = all.joined(boxes.bounds(boxes.nodes[0], i));
  if (squared_distance(all, point) > 0.0) return 1.0;
  double angle = 0.0; // 4 pi inside, 0 outside
  for (int i = 0; i < static_cast<int>(mesh.triangles().size()); ++i)
    angle += solid_angle(mesh.corner(i, 0) - point, mesh.corner(i, 1) - point,
                         mesh.corner(i, 2) - point);
  return 2.0 * std::numbers::pi - angle;
}

Bounds bounds(const Mesh& mesh, const Transform& to_world) {
  return placed_bounds(mesh, to_world, mesh.hierarchy().nodes[0], 2);
}

} // namespace abbe
