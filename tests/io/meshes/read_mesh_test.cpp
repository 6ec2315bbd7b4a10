#include "tests/io/scene_language/read_scene_helpers.h"

#include "geometry/world/world.h"
#include "tests/catch.h"

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <optional>

using namespace abbe;

namespace {

const std::string kCubeObj = "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\n"
                             "v -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
                             "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
const std::string kTetrahedronPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

/// A scene and a mesh in a folder of their own, removed at the end.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("abbe_mesh_test." + std::to_string(::getpid()));
  std::vector<std::string> warnings;

  Folder() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path / "parts");
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
  }
  Scene read(const std::string& text) {
    return read_scene_text(text, path / "s.sdl",
                           [&](const std::string& message) { warnings.push_back(message); });
  }
  std::string error(const std::string& text) {
    try {
      (void)read(text);
    } catch (const ReadError& error) {
      std::string message = error.what();
      const std::string folder = path.string() + "/";
      for (std::size_t at; (at = message.find(folder)) != std::string::npos;)
        message.erase(at, folder.size());
      return message;
    }
    return "no error";
  }
};

} // namespace

TEST_CASE("meshes in OBJ and PLY become solids where they are closed") {
  Folder folder;
  folder.write("cube.obj", kCubeObj);
  folder.write("parts/corner.PLY", kTetrahedronPly);
  folder.write("parts/part.sdl", "mesh corner.PLY");
  const Scene scene =
      folder.read("glass N-BK7 mesh cube.obj translate 5 0 0 include parts/part.sdl");
  REQUIRE(scene.shapes.size() == 2);
  CHECK(std::get<Mesh>(scene.shapes[0].shape).triangles().size() == 12);
  CHECK(std::get<Mesh>(scene.shapes[0].shape).vertices().size() == 8);
  CHECK(scene.shapes[0].medium.valid());
  CHECK(contains(scene.shapes[0], {0.9, -0.9, 0.9}));
  CHECK(contains(scene.shapes[1], {5.1, 0.1, 0.1}));
  CHECK_FALSE(contains(scene.shapes[1], {5.9, 0.9, 0.9}));
  CHECK(folder.warnings.empty());
}

TEST_CASE("a file that is named again shares its triangles, under whatever name") {
  Folder folder;
  folder.write("cube.obj", kCubeObj);
  folder.write("copy.obj", kCubeObj);
  folder.write("parts/part.sdl", "mesh ../cube.obj");
  std::filesystem::create_symlink(folder.path / "cube.obj", folder.path / "link.obj");
  const Scene scene =
      folder.read("def block { mesh cube.obj } use block translate 3 0 0 use block "
                  "mesh ./cube.obj mesh link.obj include parts/part.sdl mesh copy.obj");
  REQUIRE(scene.shapes.size() == 6);
  const auto vertices = [&](std::size_t i) {
    return std::get<Mesh>(scene.shapes[i].shape).vertices().data();
  };
  for (std::size_t i = 1; i < 5; ++i)
    CHECK(vertices(i) == vertices(0));
  CHECK(vertices(5) != vertices(0));
  const World world(scene.shapes, 10.0);
  CHECK(std::get<Mesh>(world.shapes()[3].shape).vertices().data() == vertices(0));
  CHECK(contains(world.shapes()[2], {3.9, 0.9, 0.9}));
}

TEST_CASE("a library that an OBJ names is not opened, and concave ends stay concave") {
  Folder folder;
  folder.write("l.obj", "mtllib parts\n" // an L, 2 x 2 x 1, its ends polygons of six corners
                        "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
                        "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
                        "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\n"
                        "f 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n");
  const Scene scene = folder.read("mesh l.obj");
  const Mesh& mesh = std::get<Mesh>(scene.shapes[0].shape);
  CHECK(mesh.is_closed());
  CHECK(mesh.triangles().size() == 20);
  CHECK(mesh.area() == Approx(2 * 3 + 8)); // two ends of area 3, a wall of length 8 and height 1
  CHECK(contains(scene.shapes[0], {0.5, 1.5, 0.5}));
  CHECK_FALSE(contains(scene.shapes[0], {1.25, 1.25, 0.5}));
  CHECK(folder.warnings.empty());
}

TEST_CASE("a mesh that can be mended becomes a solid, with one word on what was changed") {
  Folder folder;
  std::string turned = kCubeObj; // its last face, which is two triangles
  turned.replace(turned.rfind("2 4 8 6"), 7, "6 8 4 2");
  folder.write("turned.obj", turned);
  folder.write("seam.obj", kCubeObj + "v 1 1.0000001 1\nf 8 9 1\nf 1 8 9\n");
  const Scene scene = folder.read("glass N-BK7 mesh turned.obj mesh turned.obj");
  CHECK(scene.shapes[0].medium.valid());
  CHECK(contains(scene.shapes[1], {0.9, -0.9, 0.9}));
  REQUIRE(folder.warnings.size() == 1);
  CHECK(folder.warnings[0] ==
        (folder.path / "turned.obj").string() +
            ": the mesh has been mended, so that it bounds a solid: 2 triangles were turned over");
}

TEST_CASE("glass in an open mesh is an error that says where it is open, and what would help") {
  Folder folder;
  folder.write("leaf.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::string lidless = kCubeObj;
  lidless.erase(lidless.find("f 5 6 8 7\n"), 10);
  folder.write("lidless.obj", lidless);
  CHECK(folder.error("mesh leaf.obj glass N-BK7 mesh leaf.obj") ==
        "s.sdl:1:27: the mesh is not closed, so that nothing can fill it (3 edges do not join "
        "triangles in pairs; the first goes from (0 0 0) to (1 0 0)). Close it where it was made "
        "(fill its holes, merge its vertices, remove walls inside it), or give thinGlass for a "
        "sheet");
  CHECK(folder.error("mesh lidless.obj thinGlass 1 N-BK7 mesh lidless.obj") == "no error");
  const std::string error = folder.error("speedOfLight 1.5 transparency 1 mesh lidless.obj");
  CHECK(error.find("s.sdl:1:33: the mesh is not closed, so that nothing can fill it (4 edges do "
                   "not join triangles in pairs; the first goes from (") == 0);
  CHECK(folder.warnings.empty());
}

TEST_CASE("errors of meshes") {
  Folder folder;
  folder.write("cube.off", "solid");
  folder.write("bad.ply", "this is no ply file");
  folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  CHECK(folder.error("mesh cube.off") == "s.sdl:1:6: \"cube.off\" is no mesh (its name ends "
                                         "neither in .obj nor in .ply nor in .stl). Give a file "
                                         "of one of these formats");
  CHECK(folder.error("mesh no.ply") ==
        "s.sdl:1:6: there is no file \"no.ply\" (meshes are found relative to the file that names "
        "them). Check the name, or write the whole path");
  CHECK(folder.error("mesh bad.ply") ==
        "bad.ply:1:1: this is no PLY file (it does not begin with a line \"ply\"). Write the mesh "
        "again [mesh at s.sdl:1:6]");
  REQUIRE(::mkfifo((folder.path / "pipe.ply").c_str(), 0600) == 0);
  CHECK(folder.error("mesh pipe.ply") ==
        "s.sdl:1:6: \"pipe.ply\" cannot be read (it is a pipe). Give a file of triangles or "
        "polygons, as OBJ, PLY or STL");
  CHECK(
      folder.error("mesh points.obj") ==
      "s.sdl:1:6: \"points.obj\" holds no surface (there is no triangle with an area). Give a file "
      "with triangles or polygons");
  CHECK(
      folder.error("union cube mesh cube.obj") ==
      "s.sdl:1:12: mesh cannot be an operand (booleans combine convex solids). Give it a place of "
      "its own, with a priority where it overlaps others");
}
