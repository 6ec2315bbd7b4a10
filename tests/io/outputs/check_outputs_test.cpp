#include "io/outputs/check_outputs.h"

#include "core/scene/user_error.h"
#include "io/images/write_exr.h"
#include "io/scene_files/read_scene_file.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <fstream>
#include <set>

using namespace abbe;
namespace fs = std::filesystem;

namespace {

/// A scene that reads a file of every kind that a scene can name, one of them without naming it.
const std::vector<std::string> kFiles{"s.sdl",    "part.sdl", "a.filter", "all.mtl",
                                      "tile.exr", "sky.exr",  "a.obj",    "a.lens"};

void write_files(const fs::path& folder) {
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder / name) << text;
  };
  std::string samples = "81";
  for (int i = 0; i < 81; ++i)
    samples += " 0.5";
  write("s.sdl", "lights a.filter include part.sdl lensFile a.lens filmHeight 24 eye 0 0 500\n"
                 "environment sky.exr light L 0 0 1 0 UseMaterial M mesh a.obj\n"
                 "imageTexture tile.exr square");
  write("part.sdl", "sphere");
  write("a.filter", "filter L { colour " + samples + " }");
  write("all.mtl", "def M { diffuseAmount 1 }");
  write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("a.lens", "stop surface 50 5 N-BK7 10 surface -50 48 air 10");
  for (const char* name : {"sky.exr", "tile.exr"})
    write_exr(folder / name, {{0, 0, 1, 1}, {0, 0, 1, 1}, {0.5f, 0.5f, 0.5f, 1.0f}, {}},
              ExrPixel::half);
}

/// What is said of an output of this name; "" when it may be written.
std::string said(const Outputs& outputs, const InputFiles& inputs) {
  try {
    check_outputs(outputs, inputs);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a scene tells all files that it was read from") {
  const test::Folder folder;
  write_files(folder.path);
  InputFiles inputs;
  (void)read_scene_file(folder.path / "s.sdl", {}, &inputs);
  std::set<fs::path> read(inputs.begin(), inputs.end()), written;
  for (const std::string& name : kFiles)
    written.insert(folder.path / name);
  CHECK(read == written);
}

TEST_CASE("no output replaces a file that the scene was read from") {
  const test::Folder folder;
  write_files(folder.path);
  InputFiles inputs;
  (void)read_scene_file(folder.path / "s.sdl", {}, &inputs);
  const fs::path good = folder.path / "o.exr";
  CHECK(said({{good}, folder.path / "h.exr"}, inputs).empty());
  for (const char* name : {"tile.exr", "sky.exr"}) {
    const std::string file = (folder.path / name).string();
    const std::string right = file + ": this picture would replace " + file +
                              ", which the scene is read from. Give the output another name";
    CHECK(said({{good, file}, {}}, inputs) == right);
    CHECK(said({{good}, file}, inputs) == right);
  }
}

TEST_CASE("an input is found by another name of it, and by that of a partial image") {
  const test::Folder folder;
  write_files(folder.path);
  const fs::path sky = folder.path / "sky.exr";
  fs::create_symlink("sky.exr", folder.path / "link.exr");
  for (const fs::path& name : {folder.path / "link.exr", folder.path / "." / "sky.exr",
                               folder.path / ".." / folder.path.filename() / "sky.exr"})
    CHECK(said({{name}, {}}, {sky}).find("would replace " + sky.string()) != std::string::npos);
  const fs::path partial = folder.path / "x.partial.exr";
  fs::copy_file(sky, partial);
  CHECK(said({{folder.path / "x.png"}, {}}, {partial}) ==
        partial.string() + ": what an interrupted render leaves would replace " + partial.string() +
            ", which the scene is read from. Give the output another name");
}

TEST_CASE("files that are written beside the pictures are checked like these") {
  const test::Folder folder;
  write_files(folder.path);
  const auto said_of = [&](const std::vector<fs::path>& further) -> std::string {
    try {
      check_outputs({{folder.path / "o.exr"}, {}}, std::vector{folder.path / "sky.exr"}, further);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(said_of({folder.path / "o.depth.exr"}).empty());
  CHECK(said_of({folder.path / "o.exr"}).find("two outputs") != std::string::npos);
  CHECK(said_of({folder.path / "sky.exr"}).find("would replace") != std::string::npos);
  fs::create_directory(folder.path / "o.depth.exr");
  CHECK(said_of({folder.path / "o.depth.exr"}).find("cannot write") != std::string::npos);
}
