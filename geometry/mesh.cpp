#include "geometry/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace abbe {
namespace {

constexpr std::int32_t kMostInLeaf = 4;

/// True when each directed edge has its opposite, and none comes twice.
bool edges_match(const std::vector<Triangle>& triangles) {
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!edges.emplace(t[i], t[(i + 1) % 3]).second) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.contains({e.second, e.first});
  });
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

/// A line seen along itself: the largest part of its direction is the third axis, and the others
/// are sheared so that it runs along that axis [WBW13]. A triangle's edge then
/// passes the origin on one side or the other, the same for both triangles that share it.
class ShearedLine {
public:
  explicit ShearedLine(const LocalRay& ray) : origin_(ray.origin) {
    const dvec3& d = ray.direction;
    for (int i = 1; i < 3; ++i)
      if (std::abs(d[i]) > std::abs(d[z_])) z_ = i;
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_ = {d[x_] / d[z_], d[y_] / d[z_], 1.0 / d[z_]};
  }

  [[nodiscard]] dvec3 seen(const dvec3& point) const {
    const dvec3 p = point - origin_;
    return {p[x_] - shear_.x * p[z_], p[y_] - shear_.y * p[z_], shear_.z * p[z_]};
  }

  /// True when the third axis points against the line: what it sees as mirrored is not.
  [[nodiscard]] bool reversed() const { return shear_.z < 0.0; }

private:
  dvec3 origin_, shear_;
  int x_ = 1, y_ = 2, z_ = 0;
};

double edge(const dvec3& p, const dvec3& q) {
  return p.x * q.y - p.y * q.x;
}

struct Crossed {
  double t;
  bool outwards;
};

/// Where a line crosses a triangle, if it does, and whether it runs with the normal. Both follow
/// from the same signs, so that a line enters and leaves a closed mesh in turn.
std::optional<Crossed> crossed(const Mesh& mesh, int triangle, const ShearedLine& line) {
  const dvec3 a = line.seen(mesh.corner(triangle, 0)), b = line.seen(mesh.corner(triangle, 1)),
              c = line.seen(mesh.corner(triangle, 2));
  const double u = edge(b, c), v = edge(c, a), w = edge(a, b);
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return std::nullopt;
  const double sum = u + v + w;
  if (sum == 0.0) return std::nullopt; // seen from its edge
  return Crossed{(u * a.z + v * b.z + w * c.z) / sum, (sum > 0.0) != line.reversed()};
}

/// True when the line between t = 0 and `farthest` may meet the box grown by `margin`.
bool meets(const Bounds& box, const LocalRay& ray, double margin, double farthest) {
  double first = 0.0, last = farthest;
  for (int i = 0; i < 3; ++i) {
    const double low = box.lower[i] - margin - ray.origin[i];
    const double high = box.upper[i] + margin - ray.origin[i];
    const double d = ray.direction[i];
    if (d == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    first = std::max(first, std::min(low / d, high / d));
    last = std::min(last, std::max(low / d, high / d));
  }
  return first <= last;
}

bool before(const Root& a, const Root& b) {
  return std::tie(a.t, a.face.face) < std::tie(b.t, b.face.face);
}

} // namespace

Mesh::Mesh(const std::vector<dvec3>& vertices, const std::vector<Triangle>& triangles) {
  std::map<std::tuple<double, double, double>, std::int32_t> places;
  std::vector<std::int32_t> merged;
  for (const dvec3& p : vertices) {
    const auto number = static_cast<std::int32_t>(vertices_.size());
    const auto [place, is_new] = places.emplace(std::tuple(p.x, p.y, p.z), number);
    if (is_new) vertices_.push_back(p);
    merged.push_back(place->second);
    size_ = std::max({size_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  for (const Triangle& t : triangles) {
    Triangle found{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < 0 || static_cast<std::size_t>(t[i]) >= merged.size())
        throw std::invalid_argument("a triangle has a corner that is no vertex");
      found[i] = merged[static_cast<std::size_t>(t[i])];
    }
    const auto at = [&](std::size_t i) { return vertices_[static_cast<std::size_t>(found[i])]; };
    if (squared(glm::cross(at(1) - at(0), at(2) - at(0))) > 0.0) triangles_.push_back(found);
  }
  if (triangles_.empty()) throw std::invalid_argument("there is no triangle with an area");
  closed_ = edges_match(triangles_);
  double volume = 0.0; // six times that of the tetrahedra with a corner at the first vertex
  for (int i = 0; i < static_cast<int>(triangles_.size()); ++i)
    volume += glm::dot(corner(i, 0) - vertices_[0],
                       glm::cross(corner(i, 1) - vertices_[0], corner(i, 2) - vertices_[0]));
  if (closed_ && volume < 0.0)
    for (Triangle& t : triangles_)
      std::swap(t[1], t[2]);
  build(0, static_cast<std::int32_t>(triangles_.size()));
}

void Mesh::build(std::int32_t first, std::int32_t count) {
  const auto place = nodes_.size();
  nodes_.push_back({{}, first, count});
  Bounds centres;
  const auto centre = [&](const Triangle& t) {
    dvec3 sum(0.0);
    for (const std::int32_t i : t)
      sum += vertices_[static_cast<std::size_t>(i)];
    return sum;
  };
  for (std::int32_t i = first; i < first + count; ++i) {
    for (int c = 0; c < 3; ++c)
      nodes_[place].box = nodes_[place].box.joined({corner(i, c), corner(i, c)});
    const dvec3 middle = centre(triangles_[static_cast<std::size_t>(i)]);
    centres = centres.joined({middle, middle});
  }
  if (count <= kMostInLeaf) return;
  const dvec3 extent = centres.upper - centres.lower;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto begin = triangles_.begin() + first;
  const std::int32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [&](const Triangle& a, const Triangle& b) {
    return std::pair(centre(a)[axis], a) < std::pair(centre(b)[axis], b);
  });
  build(first, half);
  nodes_[place].first = static_cast<std::int32_t>(nodes_.size());
  nodes_[place].count = 0;
  build(first + half, count - half);
}

MeshCrossings first_crossings(const Mesh& mesh, const LocalRay& ray, int touched) {
  const double speed = glm::length(ray.direction);
  const double way = (glm::length(ray.origin) + 2.0 * mesh.size()) / speed; // to its far side
  const double margin = 4.0 * ray.shift_at(way, mesh.size());
  const ShearedLine line(ray);
  MeshCrossings found;
  std::array<std::int32_t, 64> stack{}; // halving 2^31 triangles needs half of it
  std::size_t top = 1;
  while (top > 0) {
    const std::int32_t place = stack[--top];
    const Mesh::Node& node = mesh.nodes()[static_cast<std::size_t>(place)];
    if (!meets(node.box, ray, margin, std::max(found.enter.t, found.exit.t))) continue;
    if (node.count == 0) {
      stack[top++] = place + 1;
      stack[top++] = node.first;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (i == touched) continue;
      const auto met = crossed(mesh, i, line);
      if (!met) continue;
      const double cosine = std::abs(glm::dot(outward_normal(mesh, {}, i), ray.direction));
      if (cosine == 0.0) continue;
      Root root{met->t, plane_root_error(ray, cosine, met->t, mesh.size()), {0, i}};
      if (root.t < -root.t_error) continue;
      root.t = std::max(0.0, root.t);
      Root& first = met->outwards ? found.exit : found.enter;
      if (before(root, first)) first = root;
    }
  }
  return found;
}

dvec3 outward_normal(const Mesh& mesh, const dvec3&, int face) {
  const dvec3& a = mesh.corner(face, 0);
  return glm::normalize(glm::cross(mesh.corner(face, 1) - a, mesh.corner(face, 2) - a));
}

dvec3 snapped(const Mesh& mesh, const dvec3& point, int face) {
  const dvec3 n = outward_normal(mesh, point, face);
  return point - glm::dot(n, point - mesh.corner(face, 0)) * n;
}

int nearest_face(const Mesh& mesh, const dvec3& point) {
  int nearest = 0;
  double smallest = kInfinity;
  for (int i = 0; i < static_cast<int>(mesh.triangles().size()); ++i) {
    const double distance = squared_distance(mesh.corner(i, 0) - point, mesh.corner(i, 1) - point,
                                             mesh.corner(i, 2) - point);
    if (distance < smallest) {
      smallest = distance;
      nearest = i;
    }
  }
  return nearest;
}

double signed_distance(const Mesh& mesh, const dvec3& point) {
  if (!mesh.is_closed()) return 1.0;
  double angle = 0.0; // 4 pi inside, 0 outside
  for (int i = 0; i < static_cast<int>(mesh.triangles().size()); ++i)
    angle += solid_angle(mesh.corner(i, 0) - point, mesh.corner(i, 1) - point,
                         mesh.corner(i, 2) - point);
  return 2.0 * std::numbers::pi - angle;
}

Bounds bounds(const Mesh& mesh, const Transform& to_world) {
  Bounds box;
  for (const dvec3& v : mesh.vertices()) {
    const dvec3 p = to_world.point(v);
    box = box.joined({p, p});
  }
  return box;
}

} // namespace abbe
