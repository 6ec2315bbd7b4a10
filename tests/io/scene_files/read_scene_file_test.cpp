#include "io/scene_files/read_scene_file.h"

#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <fstream>

using namespace abbe;
using test::Folder;

TEST_CASE("the extension tells the format, in upper or lower case") {
  const Folder folder;
  std::ofstream(folder.path / "a.sdl") << "sphere";
  std::ofstream(folder.path / "b.SDL") << "sphere sphere";
  CHECK(read_scene_file(folder.path / "a.sdl", {}).shapes.size() == 1);
  CHECK(read_scene_file(folder.path / "b.SDL", {}).shapes.size() == 2);
}

TEST_CASE("an unknown extension is refused, with what can be read") {
  CHECK(known_scene_extensions() == ".sdl, .pbrt, .glb or .gltf");
  CHECK_THROWS_WITH(read_scene_file("a.obj", {}),
                    "a.obj: no scene can be read under this name (its extension is \".obj\"). The "
                    "name should end in .sdl, .pbrt, .glb or .gltf");
  CHECK_THROWS_WITH(read_scene_file("folder/a", {}),
                    "folder/a: no scene can be read under this name (it has no extension, which "
                    "tells the format). The name should end in .sdl, .pbrt, .glb or .gltf");
}
