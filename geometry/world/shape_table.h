#pragma once

#include "geometry/rays/frame.h"
#include "geometry/world/shape.h"

#include <vector>

namespace abbe {

/// What boundaries must know of a scene's shapes, computed once: small rows in place of the
/// shapes themselves, and the normals of plane faces. The shapes must stay where they are.
class ShapeTable {
public:
  struct Row {
    explicit Row(const PlacedShape& shape)
        : from_world(shape.to_world), to_world(shape.to_world), placed(&shape),
          material(shape.material), medium(shape.medium), priority(shape.priority),
          gives_way(shape.gives_way), solid(is_solid(shape.shape)),
          tree(std::holds_alternative<CsgTree>(shape.shape)), smooth(is_smooth(shape.shape)) {}

    Frame from_world;
    Placement to_world;
    const PlacedShape* placed;
    MaterialId material; ///< of the shape; operands of a tree may have their own
    MediumId medium;
    int priority;
    std::int32_t first_normal = -1; ///< in `normals_`; negative: its faces are not all plane
    bool gives_way, solid, tree;
    bool smooth; ///< it has shading normals of its own
  };

  ShapeTable() = default;
  explicit ShapeTable(const std::vector<PlacedShape>& shapes);

  [[nodiscard]] const Row& operator[](ShapeId id) const { return rows_[id.index()]; }
  /// The unit normal in the world of a face of a shape whose faces are all plane.
  [[nodiscard]] const dvec3& normal(const Row& row, FaceId face) const {
    return normals_[static_cast<std::size_t>(row.first_normal + face.face)];
  }

private:
  std::vector<Row> rows_;
  std::vector<dvec3> normals_;
};

} // namespace abbe
