#pragma once

#include "geometry/interval.h"
#include "geometry/local_ray.h"
#include "geometry/transform.h"

#include <array>
#include <optional>
#include <vector>

namespace abbe {

/// The corners of a triangle: indices into a mesh's vertices, counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/// A surface of triangles; face i is triangle i. Where each edge joins two triangles of one sense
/// it is closed, and a solid.
class Mesh {
public:
  /// Vertices at the same place count as one; triangles without area are dropped. A closed mesh
  /// that is inside out is turned. Throws std::invalid_argument when no triangle is left or an
  /// index points nowhere.
  Mesh(const std::vector<dvec3>& vertices, const std::vector<Triangle>& triangles);

  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] bool is_closed() const { return closed_; }
  [[nodiscard]] const dvec3& corner(int triangle, int i) const {
    const auto t = static_cast<std::size_t>(triangle), c = static_cast<std::size_t>(i);
    return vertices_[static_cast<std::size_t>(triangles_[t][c])];
  }
  /// The largest magnitude of a coordinate.
  [[nodiscard]] double size() const { return size_; }

  /// A box around triangles; a leaf holds the `count` from `first` on, else its halves are the next
  /// node and the one at `first`.
  struct Node {
    Bounds box;
    std::int32_t first = 0, count = 0;
  };
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

private:
  void build(std::int32_t first, std::int32_t count);

  std::vector<dvec3> vertices_;
  std::vector<Triangle> triangles_; ///< in the order of the leaves
  std::vector<Node> nodes_;
  double size_ = 0.0;
  bool closed_ = false;
};

/// Where a line crosses a mesh; of an open one, against its normal is entering.
struct MeshCrossings {
  Root enter{kInfinity, 0.0, {}};
  Root exit{kInfinity, 0.0, {}};
};

/// The first crossings of either kind that do not lie behind the origin by more than rounding.
/// Triangle `touched` is not asked. Of lines close to an edge, exactly one of its triangles is met.
[[nodiscard]] MeshCrossings first_crossings(const Mesh& mesh, const LocalRay& ray, int touched);

[[nodiscard]] dvec3 outward_normal(const Mesh& mesh, const dvec3& point, int face);
[[nodiscard]] dvec3 snapped(const Mesh& mesh, const dvec3& point, int face);
[[nodiscard]] int nearest_face(const Mesh& mesh, const dvec3& point);
/// Negative inside a closed mesh, else positive; only the sign has a meaning. Asks each triangle.
[[nodiscard]] double signed_distance(const Mesh& mesh, const dvec3& point);
[[nodiscard]] Bounds bounds(const Mesh& mesh, const Transform& to_world);

} // namespace abbe
