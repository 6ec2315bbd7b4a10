// A convex solid with flat faces, by the planes that bound it or by the points that it spans:
//
//   polyhedron planes 4  1 1 1 1  1 -1 -1 1  -1 1 -1 1  -1 -1 1 1   ! n.p <= d
//   polyhedron vertices 4  0 0 0  1 0 0  0 1 0  0 0 1

#include "geometry/rays/largest_component.h"
#include "geometry/solids/convex_hull.h"
#include "io/scene_language/read_scene_state.h"

#include <glm/geometric.hpp>

#include <stdexcept>

namespace abbe {
namespace {

constexpr double kMostPlanes = 256, kMostVertices = 128; ///< their corners and faces are tried out

std::vector<HalfSpace> read_planes(Arguments& arguments) {
  const auto count = arguments.whole_number({"the number of planes", 4, kMostPlanes});
  std::vector<HalfSpace> planes;
  for (std::int64_t i = 0; i < count; ++i) {
    const SourcePosition where = arguments.reader().peek().where;
    const dvec3 normal = arguments.vector();
    const double size = largest_component(normal);
    if (size == 0.0)
      throw ReadError(where, "a plane's normal has no direction", "it is 0 0 0",
                      "Give the direction in which the plane looks outwards");
    planes.push_back({normal / size, arguments.number() / size});
  }
  return planes;
}

std::vector<HalfSpace> read_vertices(Arguments& arguments) {
  const auto count = arguments.whole_number({"the number of vertices", 4, kMostVertices});
  std::vector<dvec3> vertices;
  for (std::int64_t i = 0; i < count; ++i)
    vertices.push_back(arguments.vector());
  return hull_planes(vertices);
}

} // namespace

ConvexPolyhedron read_polyhedron(Arguments& arguments) {
  const bool by_planes = arguments.choice<bool>({{"planes", true}, {"vertices", false}});
  try {
    return ConvexPolyhedron(by_planes ? read_planes(arguments) : read_vertices(arguments));
  } catch (const std::invalid_argument& error) {
    throw ReadError(arguments.keyword().where, "this polyhedron is no solid", error.what(),
                    by_planes ? "Give planes that look outwards on all sides of a point"
                              : "Give vertices that do not lie in one plane");
  }
}

} // namespace abbe
