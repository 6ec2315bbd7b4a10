#include "geometry/solids/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

/// How far apart points count as distinct: lengths that rounding of the planes cannot blur.
double slack(const std::vector<HalfSpace>& planes) {
  double size = 0.0;
  for (const HalfSpace& h : planes)
    size = std::max(size, std::abs(h.offset));
  return 1e-9 * size;
}

/// Every point where three planes meet that no half-space excludes.
std::vector<dvec3> corners(const std::vector<HalfSpace>& planes) {
  const double margin = slack(planes);
  std::vector<dvec3> found;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const dvec3 edge = glm::cross(planes[i].normal, planes[j].normal);
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const double volume = glm::dot(edge, planes[k].normal);
        if (std::abs(volume) < 1e-12) continue; // three planes through one line, or parallel
        const dvec3 p = (planes[k].offset * edge +
                         planes[i].offset * glm::cross(planes[j].normal, planes[k].normal) +
                         planes[j].offset * glm::cross(planes[k].normal, planes[i].normal)) /
                        volume;
        if (std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
              return glm::dot(h.normal, p) <= h.offset + margin;
            }))
          found.push_back(p);
      }
    }
  return found;
}

double height_above(const HalfSpace& h, const dvec3& point) {
  return glm::dot(h.normal, point) - h.offset;
}

/// True when the mean of the corners lies under every plane, not in one.
bool has_volume(const std::vector<HalfSpace>& planes, const std::vector<dvec3>& corners) {
  dvec3 mean(0.0);
  for (const dvec3& corner : corners)
    mean += corner / static_cast<double>(corners.size());
  return !corners.empty() && std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
    return glm::dot(h.normal, mean) < h.offset - slack(planes);
  });
}

/// True when the half-spaces leave some direction open: a direction d with n.d <= 0 for all n.
/// Candidates are the lines in which pairs of planes meet, and each normal's opposite.
bool open_somewhere(const std::vector<HalfSpace>& planes) {
  const auto open = [&](const dvec3& d) {
    return std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
      return glm::dot(h.normal, d) <= 1e-12 * glm::length(d);
    });
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (open(-planes[i].normal)) return true;
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const dvec3 d = glm::cross(planes[i].normal, planes[j].normal);
      if (glm::length(d) > 1e-12 && (open(d) || open(-d))) return true;
    }
  }
  return false;
}

} // namespace

ConvexPolyhedron::ConvexPolyhedron(std::vector<HalfSpace> half_spaces)
    : half_spaces_(std::move(half_spaces)) {
  for (HalfSpace& h : half_spaces_) {
    const double length = glm::length(h.normal);
    if (!(length > 0.0)) throw std::invalid_argument("a plane needs a normal of non-zero length");
    h.normal /= length;
    h.offset /= length;
  }
  fours_.resize((half_spaces_.size() + 3) / 4);
  for (std::size_t i = 0; i < half_spaces_.size(); ++i) {
    FourHalfSpaces& four = fours_[i / 4];
    const HalfSpace& h = half_spaces_[i];
    four.x[i % 4] = h.normal.x;
    four.y[i % 4] = h.normal.y;
    four.z[i % 4] = h.normal.z;
    four.offset[i % 4] = h.offset;
  }
  vertices_ = corners(half_spaces_);
  if (open_somewhere(half_spaces_))
    throw std::invalid_argument("the planes leave the solid open to infinity");
  if (!has_volume(half_spaces_, vertices_))
    throw std::invalid_argument("the planes enclose no volume");
}

ConvexPolyhedron thesis_prism() {
  const double h = std::numbers::sqrt3 / 2.0;
  return ConvexPolyhedron(
      {{{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, 1}, {{-h, 0, -0.5}, 1}, {{h, 0, -0.5}, 1}});
}

std::optional<Interval> intersect(const ConvexPolyhedron& solid, const LocalRay& ray,
                                  const FaceContact* contact) {
  return with_errors(solid, ray, contact);
}

dvec3 outward_normal(const ConvexPolyhedron& solid, const dvec3&, int face) {
  return solid.half_spaces()[static_cast<std::size_t>(face)].normal;
}

int nearest_face(const ConvexPolyhedron& solid, const dvec3& point, const dvec3& direction) {
  const auto& planes = solid.half_spaces();
  std::size_t nearest = 0;
  double highest = -kInfinity;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double height = height_above(planes[i], point);
    if (height <= highest || runs_in(planes[i].normal, direction)) continue;
    highest = height;
    nearest = i;
  }
  return static_cast<int>(nearest);
}

double signed_distance(const ConvexPolyhedron& solid, const dvec3& point) {
  double highest = -kInfinity;
  for (const HalfSpace& h : solid.half_spaces())
    highest = std::max(highest, height_above(h, point));
  return highest;
}

Bounds bounds(const ConvexPolyhedron& solid, const Transform& to_world) {
  Bounds box;
  for (const dvec3& v : solid.vertices()) {
    const dvec3 p = to_world.point(v);
    box = box.joined({p, p});
  }
  return box;
}

} // namespace abbe
