#include "geometry/world/shape_table.h"

namespace abbe {
namespace {

/// The number of faces of a shape whose normals do not change along them; 0 for all others.
template <class S>
int plane_faces(const S& shape) {
  if constexpr (FlatShape<S>)
    return 1;
  else if constexpr (std::is_same_v<S, Box>)
    return 6;
  else if constexpr (std::is_same_v<S, ConvexPolyhedron>)
    return static_cast<int>(shape.half_spaces().size());
  else
    return 0;
}

} // namespace

ShapeTable::ShapeTable(const std::vector<PlacedShape>& shapes) {
  rows_.reserve(shapes.size());
  for (const PlacedShape& placed : shapes) {
    Row& row = rows_.emplace_back(placed);
    std::visit(
        [&](const auto& shape) {
          const int faces = plane_faces(shape);
          if (faces > 0) row.first_normal = static_cast<std::int32_t>(normals_.size());
          for (int face = 0; face < faces; ++face)
            normals_.push_back(
                placed.to_world.normal(outward_normal(shape, dvec3(0.0), FaceId{0, face})));
        },
        placed.shape);
  }
}

} // namespace abbe
