#include "geometry/meshes/overlap.h"

#include <algorithm>
#include <array>

namespace abbe {
namespace {

constexpr std::size_t kAsked = 512;

/// How often a place is inside that lies next to a triangle, on its inner side and in a direction
/// from it.
int times_inside(const Mesh& mesh, std::int32_t face, const dvec3& origin, const dvec3& direction) {
  LocalRay ray;
  ray.origin = origin;
  ray.direction = direction;
  return first_crossings(mesh, ray, {&face, 1}, MeshSearch::sum).exits_less_entries;
}

} // namespace

std::optional<dvec3> find_overlap(const Mesh& mesh) {
  const std::size_t count = mesh.triangles().size();
  const std::size_t step = std::max<std::size_t>(1, count / kAsked);
  for (std::size_t t = 0; t < count; t += step) {
    const auto face = static_cast<std::int32_t>(t);
    const auto [a, b, c] = mesh.corners(face);
    const dvec3 centre = (a + b + c) / 3.0, inwards = -outward_normal(mesh, a, face);
    if (times_inside(mesh, face, centre, inwards) == 1) continue;
    // A ray that grazes something may miscount: a second one must say the same.
    const dvec3 slanted = glm::normalize(inwards + 0.5 * glm::normalize(b - a));
    if (times_inside(mesh, face, centre, slanted) != 1) return centre;
  }
  return std::nullopt;
}

} // namespace abbe
