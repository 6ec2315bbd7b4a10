#include "io/meshes/polygons.h"

#include "io/meshes/cut_polygon.h"

#include <fmt/format.h>

namespace abbe {
namespace {

// A leaf of the hierarchy names its first triangle and how many there are in 31 bits.
constexpr std::size_t kMostTriangles = (std::size_t{1} << 29) - 1;

} // namespace

std::vector<Triangle> triangles_of(const Polygons& polygons, const std::filesystem::path& file,
                                   const Warn& warn) {
  std::vector<Triangle> triangles;
  triangles.reserve(polygons.ends.size());
  PolygonCutter cutter;
  std::size_t begin = 0, number = 0, crossing = 0, first_crossing = 0;
  for (const std::size_t end : polygons.ends) {
    ++number;
    const std::span<const std::int32_t> corners(polygons.corners.data() + begin, end - begin);
    begin = end;
    if (!cutter.cut(polygons.vertices, corners, triangles) && ++crossing == 1)
      first_crossing = number;
    if (triangles.size() > kMostTriangles)
      throw ReadError(file, fmt::format("it holds more than {} triangles", kMostTriangles),
                      "a mesh can hold no more", "Cut it into several files");
  }
  if (crossing > 0)
    warn(fmt::format("{}: {} of {} polygons cross themselves and are cut into triangles somehow; "
                     "the first is polygon {}",
                     file.string(), crossing, polygons.ends.size(), first_crossing));
  return triangles;
}

} // namespace abbe
