#include "io/meshes/match_normals.h"

#include "io/meshes/read_mesh.h"
#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace abbe;

namespace {

Mesh mesh_from(const std::string& text, const char* file, MeshFormat format) {
  return mesh_of(text, file, format, [](const std::string&) {}).mesh;
}

/// The normal at a place of the mesh, whichever triangle that lies in.
dvec3 normal_at(const Mesh& mesh, const dvec3& place) {
  const LocalRay ray{place + dvec3(0, 0, 1), {0, 0, -1}, 0.0, 0.0};
  const int face = nearest_face(mesh, ray, true).face;
  return shading_normal(mesh, place, face).value_or(dvec3(0.0));
}

// A quad in z = 0, whose corners lean outwards.
const char* const kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                          "vn -0.6 0 0.8\nvn 0.6 0 0.8\n"
                          "f 1//1 2//2 3//2 4//1\n";

} // namespace

TEST_CASE("an OBJ's normals shade the triangles that its polygons are cut into") {
  const Mesh mesh = mesh_from(kQuad, "q.obj", MeshFormat::obj);
  REQUIRE(mesh.corner_normals());
  for (const double y : {0.1, 0.9}) {
    CHECK(glm::distance(normal_at(mesh, {0.0, y, 0.0}), dvec3(-0.6, 0, 0.8)) < 1e-6);
    CHECK(glm::distance(normal_at(mesh, {1.0, y, 0.0}), dvec3(0.6, 0, 0.8)) < 1e-6);
    CHECK(glm::distance(normal_at(mesh, {0.5, y, 0.0}), dvec3(0, 0, 1)) < 1e-6);
  }
}

TEST_CASE("normals are found by negative numbers, before and after the faces") {
  const Mesh mesh = mesh_from("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1/7/-1 2//-1 3//2\n"
                              "vn 0 0 1\n",
                              "q.obj", MeshFormat::obj);
  REQUIRE(mesh.corner_normals());
  CHECK(glm::distance(normal_at(mesh, {0.0, 1.0, 0.0}), dvec3(0, 0, 1)) < 1e-6);
  CHECK(glm::distance(normal_at(mesh, {0.5, 0.0, 0.0}), dvec3(0.6, 0, 0.8)) < 1e-6);
}

TEST_CASE("normals that are those of the triangles change nothing") {
  const Mesh mesh = mesh_from("v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0.0000 0.0001 1.0000\n"
                              "f 1//1 2//1 3//1\n",
                              "q.obj", MeshFormat::obj);
  CHECK(mesh.corner_normals() == nullptr);
}

TEST_CASE("a face without normals, or with one of length 0, is flat beside smooth ones") {
  const Mesh mesh =
      mesh_from("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvn 0.6 0 0.8\nvn 0 0 0\n"
                "f 1//1 2//1 3//1\nf 1 3 4\nf 2//1 5//2 3//1\n",
                "q.obj", MeshFormat::obj);
  REQUIRE(mesh.corner_normals());
  CHECK(normal_at(mesh, {0.9, 0.2, 0.0}).x == Approx(0.6).margin(1e-6));
  CHECK(normal_at(mesh, {0.2, 0.9, 0.0}) == dvec3(0.0));
  CHECK(normal_at(mesh, {1.5, 0.2, 0.0}) == dvec3(0.0));
}

TEST_CASE("a PLY's vertices bring their normals, in text and in bytes") {
  const std::string head =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + head;
  for (const float value :
       {0.f, 0.f, 0.f, .6f, 0.f, .8f, 1.f, 0.f, 0.f, .6f, 0.f, .8f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f})
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  bytes += '\3';
  for (const std::int32_t corner : {0, 1, 2})
    bytes.append(reinterpret_cast<const char*>(&corner), sizeof corner);
  for (const std::string& file :
       {"ply\nformat ascii 1.0\n" + head + "0 0 0 .6 0 .8\n1 0 0 .6 0 .8\n0 1 0 0 0 1\n3 0 1 2\n",
        bytes}) {
    const Mesh mesh = mesh_from(file, "q.ply", MeshFormat::ply);
    REQUIRE(mesh.corner_normals());
    CHECK(glm::distance(normal_at(mesh, {0.5, 0.0, 0.0}), dvec3(0.6, 0, 0.8)) < 1e-6);
    CHECK(glm::distance(normal_at(mesh, {0.0, 1.0, 0.0}), dvec3(0, 0, 1)) < 1e-6);
  }
}

TEST_CASE("a closed mesh that is inside out keeps its normals when it is turned") {
  // A tetrahedron, its faces clockwise from outside; the normals point away from its middle.
  const Mesh mesh = mesh_from("v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\n"
                              "vn 1 1 1\nvn -1 -1 1\nvn -1 1 -1\nvn 1 -1 -1\n"
                              "f 1//1 2//2 3//3\nf 1//1 3//3 4//4\nf 1//1 4//4 2//2\nf 2//2 4//4 "
                              "3//3\n",
                              "t.obj", MeshFormat::obj);
  REQUIRE(mesh.is_closed());
  REQUIRE(mesh.corner_normals());
  for (int face = 0; face < 4; ++face)
    for (int i = 0; i < 3; ++i) {
      const dvec3 corner = mesh.corner(face, i);
      CHECK(glm::distance(*shading_normal(mesh, corner, face), glm::normalize(corner)) < 1e-6);
    }
}

TEST_CASE("a corner that names no normal is told at its place") {
  const auto error = [](const std::string& text) -> std::string {
    try {
      (void)mesh_from(text, "q.obj", MeshFormat::obj);
    } catch (const ReadError& fault) {
      return fault.what();
    }
    return "no error";
  };
  CHECK(error("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//2 3//1\n") ==
        "q.obj:5:8: \"2//2\" names no normal (there are 1 normals up to here, and they count from "
        "1). Write the mesh again");
  CHECK(error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//-1 2//7 3\n") == "no error"); // there are none
  CHECK(error("v 0 0 0\nvn 0 1\n").starts_with("q.obj:2:"));
}
