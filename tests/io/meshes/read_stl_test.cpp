#include "io/meshes/read_stl.h"

#include "tests/catch.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

using namespace abbe;

namespace {

std::string error(const std::string& bytes) {
  try {
    (void)read_stl(bytes, "m.stl");
  } catch (const ReadError& fault) {
    return fault.what();
  }
  return "no error";
}

void append(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i)
    bytes += static_cast<char>(word >> (8 * i) & 0xFFU); // little endian
}

/// A binary file of these corners, three for each triangle.
std::string binary(const std::vector<glm::vec3>& corners, std::string header = "") {
  header.resize(80, ' ');
  append(header, static_cast<std::uint32_t>(corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) header += std::string(12, '\x7f'); // a normal, which says nothing
    for (int axis = 0; axis < 3; ++axis)
      append(header, std::bit_cast<std::uint32_t>(corners[i][axis]));
    if (i % 3 == 2) header += "\x12\x34";
  }
  return header;
}

std::string text(const std::vector<glm::vec3>& corners, const std::string& end) {
  std::string lines = "solid a name" + end;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) lines += "  facet normal 0 0 1" + end + "\tOUTER LOOP" + end;
    lines += fmt::format("vertex {} {:.9e} {}", corners[i].x, corners[i].y, corners[i].z) + end;
    if (i % 3 == 2) lines += "endloop" + end + end + " endfacet" + end;
  }
  return lines + "endsolid a name" + end;
}

} // namespace

TEST_CASE("corners at one place are one vertex, and -0 is 0") {
  const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                       {0, 1, 0}, {1, 0, 0}, {1, 1, -0.0F}};
  for (const std::string& file :
       {binary(corners), binary(corners, "solid, and yet not text"), text(corners, "\n")}) {
    const Polygons mesh = read_stl(file, "m.stl");
    CHECK(mesh.vertices == std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
    CHECK(mesh.corners == std::vector<std::int32_t>{0, 1, 2, 2, 1, 3});
    CHECK(mesh.ends == std::vector<std::size_t>{3, 6});
  }
}

TEST_CASE("random triangles come back bit by bit, from text and from binary") {
  std::mt19937_64 random(20250101);
  std::uniform_real_distribution<float> coordinate(-1e3F, 1e3F);
  for (int round = 0; round < 50; ++round) {
    std::vector<glm::vec3> corners(3 * (random() % 20));
    for (glm::vec3& corner : corners)
      corner = {coordinate(random), coordinate(random), coordinate(random)};
    const Polygons mesh = read_stl(binary(corners), "m.stl");
    REQUIRE(mesh.vertices.size() == corners.size());
    REQUIRE(mesh.ends.size() == corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); ++i)
      CHECK(mesh.vertices[static_cast<std::size_t>(mesh.corners[i])] == glm::dvec3(corners[i]));
    const Polygons written = read_stl(text(corners, round % 2 == 0 ? "\n" : "\r\n"), "m.stl");
    REQUIRE(written.corners == mesh.corners);
    for (std::size_t i = 0; i < corners.size(); ++i) // text is read in double
      CHECK(glm::vec3(written.vertices[i]) == corners[i]);
  }
}

TEST_CASE("text may hold several solids, or none") {
  const std::string one = text({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "\n");
  CHECK(read_stl(one + "\n" + one, "m.stl").ends.size() == 2);
  CHECK(read_stl("solid\nendsolid", "m.stl").ends.empty());
}

TEST_CASE("errors of STL files") {
  const std::string one = text({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "\n");
  CHECK(error("") == "m.stl: this is no STL file (it neither begins with solid nor has a header). "
                     "Write the mesh again");
  CHECK(error(one.substr(0, one.find("endsolid"))) ==
        "m.stl:10:1: the file ends where endsolid should stand (it is cut off). "
        "Write the mesh again");
  CHECK(error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop") ==
        "m.stl:5:1: \"endloop\" stands where vertex should (a facet is facet, outer loop, three "
        "times vertex, endloop, endfacet). Write the mesh again");
  CHECK(error("solid\nfacet\nouter\nvertex 0 0 1e999") ==
        "m.stl:4:12: \"1e999\" is not a coordinate that is finite (no such thing can stand here). "
        "Write the mesh again");
  CHECK(error("solid\nfacet\nouter\nvertex 0 0") ==
        "m.stl:4:11: the file ends where a coordinate should stand (something is missing). "
        "Write the mesh again");

  std::string cut = binary({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  cut.pop_back();
  CHECK(error(cut) == "m.stl: it declares 1 triangles, which are 134 bytes, and has 133 bytes (it "
                      "is cut off or damaged, or no STL file). Write the mesh again");
  const float infinite = std::numeric_limits<float>::infinity();
  CHECK(error(binary({{0, 0, 0}, {1, infinite, 0}, {0, 1, 0}})) ==
        "m.stl: at byte 112, a coordinate is no finite number (a vertex has a place). "
        "Write the mesh again");
}
