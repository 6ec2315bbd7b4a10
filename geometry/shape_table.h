#pragma once

#include "geometry/shape.h"

#include <vector>

namespace abbe {

/// What boundaries must know of a scene's shapes, worked out once: small rows in place of the
/// shapes themselves, and the normals of plane faces. The shapes must stay where they are.
class ShapeTable {
public:
  struct Row {
    const PlacedShape* placed = nullptr;
    MaterialId material; ///< of the shape; operands of a tree may have their own
    MediumId medium;
    int priority = 0;
    std::int32_t first_normal = -1; ///< in `normals_`; negative: its faces are not all plane
    bool solid = false;
    bool tree = false;
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
