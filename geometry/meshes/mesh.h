#pragma once

#include "geometry/meshes/mesh_hierarchy.h"
#include "geometry/rays/interval.h"
#include "geometry/rays/local_ray.h"
#include "geometry/rays/transform.h"

#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace abbe {

/// Normals at the corners of triangles, by which a mesh is shaded smoothly.
struct CornerNormals {
  std::vector<glm::vec3> normals;     ///< unit
  std::vector<Triangle> of_triangles; ///< indices into `normals`; -1: as flat as it is
};

/// A surface of triangles; face i is triangle i. Where each edge joins two triangles of one sense
/// it is closed, and a solid. Copies share their vertices, triangles and hierarchy.
class Mesh {
public:
  /// Vertices at the same place count as one; triangles without area are dropped, the others get
  /// an order of their own, as do the vertices. A closed mesh that is inside out is turned. Throws
  /// std::invalid_argument when no triangle is left, an index points nowhere or a coordinate is
  /// not finite.
  Mesh(const std::vector<dvec3>& vertices, const std::vector<Triangle>& triangles);

  [[nodiscard]] const std::vector<dvec3>& vertices() const { return data_->vertices; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return data_->triangles; }
  [[nodiscard]] const MeshHierarchy& hierarchy() const { return data_->hierarchy; }
  [[nodiscard]] bool is_closed() const { return data_->closed; }
  [[nodiscard]] const dvec3& corner(int triangle, int i) const {
    const auto t = static_cast<std::size_t>(triangle), c = static_cast<std::size_t>(i);
    return data_->vertices[static_cast<std::size_t>(data_->triangles[t][c])];
  }
  [[nodiscard]] std::array<dvec3, 3> corners(int triangle) const {
    return {corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)};
  }
  /// The same mesh, shaded by normals at its corners, which it shares with copies. There is one
  /// row of them for each triangle.
  [[nodiscard]] Mesh shaded_by(CornerNormals normals) const;
  /// Null for a mesh that is as flat as its triangles.
  [[nodiscard]] const CornerNormals* corner_normals() const { return normals_.get(); }
  /// The sum of the triangles' areas, in the mesh's frame.
  [[nodiscard]] double area() const { return data_->area; }
  /// The largest magnitude of a coordinate.
  [[nodiscard]] double size() const { return data_->size; }
  /// The bytes that copies share.
  [[nodiscard]] std::size_t memory() const;

private:
  struct Data {
    std::vector<dvec3> vertices;
    std::vector<Triangle> triangles; ///< in the order of the hierarchy's leaves
    MeshHierarchy hierarchy;
    double size = 0.0, area = 0.0;
    bool closed = false;
  };
  std::shared_ptr<const Data> data_;
  std::shared_ptr<const CornerNormals> normals_;
};

/// Where a line crosses a mesh; of an open one, against its normal is entering.
struct MeshCrossings {
  Root enter{kInfinity, 0.0, {}};
  Root exit{kInfinity, 0.0, {}};
  int exits_less_entries = 0; ///< of `sum`
};

/// What is asked of a mesh.
enum class MeshSearch : std::uint8_t {
  enter,  ///< the first entry; and the first exit, if one surely lies ahead and not beyond
  exit,   ///< the first exit; and the first entry, likewise
  either, ///< the first of all
  sum     ///< how many exits surely lie ahead, less the entries: 1 inside a closed mesh, 0 outside
};

/// Crossings that do not lie behind the origin by more than rounding. The triangles `touched` are
/// not asked. Of lines close to an edge, exactly one of its triangles is met.
[[nodiscard]] MeshCrossings first_crossings(const Mesh& mesh, const LocalRay& ray,
                                            std::span<const std::int32_t> touched,
                                            MeshSearch search);

[[nodiscard]] dvec3 outward_normal(const Mesh& mesh, const dvec3& point, int face);
/// The normals of the triangle's corners, interpolated, on the outer side of the triangle. Unit;
/// nothing where the triangle is flat.
[[nodiscard]] std::optional<dvec3> shading_normal(const Mesh& mesh, const dvec3& point, int face);
[[nodiscard]] dvec3 snapped(const Mesh& mesh, const dvec3& point, int face);
struct NearFace {
  int face = 0;
  double distance = kInfinity;
};
/// The nearest triangle through which a ray from its origin can leave, or with `entering` get in.
[[nodiscard]] NearFace nearest_face(const Mesh& mesh, const LocalRay& ray, bool entering);
/// How far a ray that starts on a triangle is from its plane where it comes to its edge, at most.
[[nodiscard]] double depth_below(const Mesh& mesh, const LocalRay& ray, int face);
/// Negative inside a closed mesh, else positive; only the sign has a meaning. Asks each triangle
/// where the point is not outside the box around all.
[[nodiscard]] double signed_distance(const Mesh& mesh, const dvec3& point);
[[nodiscard]] Bounds bounds(const Mesh& mesh, const Transform& to_world);

} // namespace abbe
