#include "io/meshes/match_normals.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace abbe {
namespace {

/// Normals this close to that of the triangle are its own, rounded to four digits: 1.4e-4 radian.
constexpr double kFlat = 1.0 - 1e-8;

struct Hash {
  template <class Value, std::size_t n>
  std::size_t operator()(const std::array<Value, n>& values) const {
    std::size_t h = 0;
    for (const Value value : values) { // an odd number near 2^64 / phi
      h = (h ^ static_cast<std::size_t>(value)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }
};

std::array<std::uint64_t, 3> place_of(const dvec3& p) { // the 0 makes -0 a 0
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
          std::bit_cast<std::uint64_t>(p.z + 0.0)};
}

Triangle sorted(Triangle corners) {
  std::ranges::sort(corners);
  return corners;
}

bool usable(const glm::vec3& normal) {
  const float length = glm::length(normal);
  return length > 0.0f && std::isfinite(1.0f / length);
}

/// Finds the triangles of a file in the mesh that was made of them.
class Matcher {
public:
  Matcher(const Mesh& mesh, const Polygons& polygons, const CutPolygons& cut)
      : mesh_(mesh), polygons_(polygons), cut_(cut) {
    for (std::size_t i = 0; i < mesh.vertices().size(); ++i)
      numbers_.emplace(place_of(mesh.vertices()[i]), static_cast<std::int32_t>(i));
    for (std::size_t t = 0; t < cut.triangles.size(); ++t)
      if (const Triangle corners = corners_in_mesh(t); corners[0] >= 0)
        sources_.emplace(sorted(corners), t);
  }

  /// The normals of a triangle of the mesh; -1: it is flat.
  [[nodiscard]] Triangle normals_of(std::size_t triangle) const {
    constexpr Triangle kNone{-1, -1, -1};
    const Triangle& corners = mesh_.triangles()[triangle];
    const auto source = sources_.find(sorted(corners));
    if (source == sources_.end()) return kNone;
    const Triangle there = corners_in_mesh(source->second);
    const dvec3 face = outward_normal(mesh_, {}, static_cast<int>(triangle));
    Triangle normals = kNone;
    bool flat = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto place = std::ranges::find(there, corners[i]) - there.begin();
      normals[i] = cut_.normals[source->second][static_cast<std::size_t>(place)];
      if (normals[i] < 0) return kNone;
      const glm::vec3& normal = polygons_.normals[static_cast<std::size_t>(normals[i])];
      if (!usable(normal)) return kNone;
      flat = flat && std::abs(glm::dot(glm::normalize(dvec3(normal)), face)) > kFlat;
    }
    return flat ? kNone : normals;
  }

private:
  /// The numbers that the corners of one of the file's triangles have in the mesh; the first is -1
  /// where one of them is not there.
  [[nodiscard]] Triangle corners_in_mesh(std::size_t t) const {
    Triangle found{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto vertex = static_cast<std::size_t>(cut_.triangles[t][i]);
      const auto number = numbers_.find(place_of(polygons_.vertices[vertex]));
      if (number == numbers_.end()) return {-1, -1, -1};
      found[i] = number->second;
    }
    return found;
  }

  const Mesh& mesh_;
  const Polygons& polygons_;
  const CutPolygons& cut_;
  std::unordered_map<std::array<std::uint64_t, 3>, std::int32_t, Hash> numbers_;
  std::unordered_map<Triangle, std::size_t, Hash> sources_;
};

} // namespace

Mesh with_normals(const Mesh& mesh, const Polygons& polygons, const CutPolygons& cut) {
  if (cut.normals.empty()) return mesh;
  const Matcher matcher(mesh, polygons, cut);
  CornerNormals found;
  std::vector<std::int32_t> numbers(polygons.normals.size(), -1); // of the normals in use
  found.of_triangles.reserve(mesh.triangles().size());
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    Triangle& own = found.of_triangles.emplace_back(matcher.normals_of(t));
    if (own[0] < 0) continue;
    for (std::int32_t& normal : own) {
      std::int32_t& number = numbers[static_cast<std::size_t>(normal)];
      if (number < 0) {
        number = static_cast<std::int32_t>(found.normals.size());
        found.normals.push_back(glm::normalize(polygons.normals[static_cast<std::size_t>(normal)]));
      }
      normal = number;
    }
  }
  if (found.normals.empty()) return mesh;
  found.normals.shrink_to_fit();
  return mesh.shaded_by(std::move(found));
}

} // namespace abbe
