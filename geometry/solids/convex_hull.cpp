#include "geometry/solids/convex_hull.h"

#include "geometry/rays/transform.h"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

namespace abbe {
namespace {

/// A plane through three points with all others on one side, and the points that lie in it.
struct Face {
  HalfSpace half_space;
  double area = 0.0; ///< of the three points' triangle, doubled
};

/// The points of a face, by which it is known: how its plane rounds does not matter.
using Members = std::vector<bool>;

/// The half-space below a plane through three points, if all points are in it but for `slack`.
std::optional<HalfSpace> supporting(const std::vector<dvec3>& points, const dvec3& on,
                                    const dvec3& normal, double slack) {
  const bool below = std::all_of(points.begin(), points.end(),
                                 [&](const dvec3& p) { return glm::dot(normal, p - on) <= slack; });
  if (!below) return std::nullopt;
  return HalfSpace{normal, glm::dot(normal, on)};
}

} // namespace

std::vector<HalfSpace> hull_planes(const std::vector<dvec3>& points) {
  Bounds box;
  for (const dvec3& p : points)
    box = box.joined({p, p});
  const double size = points.empty() ? 0.0 : glm::length(box.upper - box.lower);
  const double slack = 1e-9 * size;

  std::map<Members, Face> faces;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const dvec3 across = glm::cross(points[j] - points[i], points[k] - points[i]);
        const double area = glm::length(across);
        if (!(area > 1e-9 * size * size)) continue; // three points on a line
        for (const double side : {1.0, -1.0}) {
          const auto plane = supporting(points, points[i], side / area * across, slack);
          if (!plane) continue;
          Members members;
          for (const dvec3& p : points)
            members.push_back(glm::dot(plane->normal, p) - plane->offset >= -slack);
          if (std::find(members.begin(), members.end(), false) == members.end())
            throw std::invalid_argument("the vertices lie in one plane");
          Face& face = faces[members];
          if (area > face.area) face = {*plane, area}; // the widest triangle tilts least
        }
      }
  if (faces.empty()) throw std::invalid_argument("the vertices lie on one line");
  std::vector<HalfSpace> planes;
  for (const auto& [members, face] : faces)
    planes.push_back(face.half_space);
  return planes;
}

} // namespace abbe
