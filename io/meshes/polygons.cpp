#include "io/meshes/polygons.h"

#include "io/meshes/cut_polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace abbe {
namespace {

// A leaf of the hierarchy names its first triangle and how many there are in 31 bits.
constexpr std::size_t kMostTriangles = (std::size_t{1} << 29) - 1;

/// The normals of the triangles that a polygon has just been cut into. `begin` is the place of its
/// first corner in the list of all.
void add_normals(const Polygons& polygons, std::size_t begin, std::span<const std::int32_t> corners,
                 CutPolygons& cut) {
  for (std::size_t t = cut.normals.size(); t < cut.triangles.size(); ++t) {
    Triangle& normals = cut.normals.emplace_back(cut.triangles[t]);
    if (polygons.corner_normals.empty()) continue; // a vertex has its own
    for (std::int32_t& normal : normals) {
      const auto place = std::ranges::find(corners, normal) - corners.begin();
      normal = polygons.corner_normals[begin + static_cast<std::size_t>(place)];
    }
  }
}

} // namespace

CutPolygons triangles_of(const Polygons& polygons, const std::filesystem::path& file,
                         const Warn& warn) {
  CutPolygons cut;
  std::vector<Triangle>& triangles = cut.triangles;
  triangles.reserve(polygons.ends.size());
  PolygonCutter cutter;
  std::size_t begin = 0, number = 0, crossing = 0, first_crossing = 0;
  for (const std::size_t end : polygons.ends) {
    ++number;
    const std::span<const std::int32_t> corners(polygons.corners.data() + begin, end - begin);
    if (!cutter.cut(polygons.vertices, corners, triangles) && ++crossing == 1)
      first_crossing = number;
    if (!polygons.normals.empty()) add_normals(polygons, begin, corners, cut);
    begin = end;
    if (triangles.size() > kMostTriangles)
      throw ReadError(file, fmt::format("it holds more than {} triangles", kMostTriangles),
                      "a mesh can hold no more", "Cut it into several files");
  }
  if (crossing > 0)
    warn(fmt::format("{}: {} of {} polygons cross themselves and are cut into triangles somehow; "
                     "the first is polygon {}",
                     file.string(), crossing, polygons.ends.size(), first_crossing));
  return cut;
}

} // namespace abbe
