#include "tests/io/scene_language/read_scene_helpers.h"

#include "tests/catch.h"

#include <unistd.h>

#include <glm/geometric.hpp>

#include <fstream>

using namespace abbe;

namespace {

double x_of(const Scene& scene, std::size_t shape) {
  return scene.shapes.at(shape).to_world.point(dvec3(0.0)).x;
}

/// Files in a folder of their own, removed at the end.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("abbe_include_test." + std::to_string(::getpid()));

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
  [[nodiscard]] std::string error(const std::string& name) const {
    try {
      (void)read_scene(path / name, {});
    } catch (const ReadError& error) {
      std::string text = error.what();
      const std::string folder = path.string() + "/";
      for (std::size_t at; (at = text.find(folder)) != std::string::npos;)
        text.erase(at, folder.size());
      return text;
    }
    return "no error";
  }
};

} // namespace

TEST_CASE("a macro's statements act where it is used") {
  const Scene scene = scene_of("def pair { sphere translate 1 0 0 sphere }\n"
                               "push translate 10 0 0 USE Pair pop use pair sphere");
  REQUIRE(scene.shapes.size() == 5);
  CHECK(x_of(scene, 0) == 10.0);
  CHECK(x_of(scene, 1) == 11.0);
  CHECK(x_of(scene, 2) == 0.0);
  CHECK(x_of(scene, 4) == 1.0); // without push the transform stays
}

TEST_CASE("macros use and define others; the last definition counts") {
  const Scene scene = scene_of("def two { def one { sphere } use one use one } use two use two\n"
                               "def one { cube cube cube } use one");
  CHECK(scene.shapes.size() == 7);
  CHECK(std::holds_alternative<Box>(scene.shapes[6].shape));
  CHECK(scene_of("def nothing {} use nothing").shapes.empty());
}

TEST_CASE("a macro brings a boolean's operands, or the whole of it") {
  const Scene scene =
      scene_of("def balls { sphere push translate 1 0 0 sphere pop }\n"
               "def drop { lens use balls }\n"
               "def open { push } def shut { pop }\n"
               "use drop difference cube use drop union use open cube use shut cube");
  REQUIRE(scene.shapes.size() == 3);
  CHECK(contains(scene.shapes[0], {0.5, 0, 0}));
  CHECK_FALSE(contains(scene.shapes[1], {0.5, 0, 0}));
}

TEST_CASE("errors inside a macro name where it was defined and used") {
  CHECK(scene_error("def ball { translate 1 x 0 sphere }\nuse ball") ==
        "s.sdl:1:24: \"x\" is not a number (translate takes x y z). Give a finite number such as "
        "2, -0.5 or 1e-3 [in macro ball, defined at no_such_folder/s.sdl:1:1, used at "
        "no_such_folder/s.sdl:2:5]");
  CHECK(scene_error("def a { translate 1 } def b { use a } use b") ==
        "s.sdl:1:21: macro a ends where a number should stand (translate takes x y z). Complete "
        "the statement [in macro a, defined at no_such_folder/s.sdl:1:1, used at "
        "no_such_folder/s.sdl:1:35] [in macro b, defined at no_such_folder/s.sdl:1:23, used at "
        "no_such_folder/s.sdl:1:43]");
  CHECK(scene_error("def half { lens sphere } use half sphere") ==
        "s.sdl:1:12: lens lacks an operand (macro half ends after 1 of 2 solids). Add a solid "
        "after it [in macro half, defined at no_such_folder/s.sdl:1:1, used at "
        "no_such_folder/s.sdl:1:30]");
  CHECK(scene_error("def three { cube sphere prism } lens use three") ==
        "s.sdl:1:25: \"prism\" stands after both operands of lens (the boolean at line 1 is "
        "complete before what brings its operands). Move it out of there, or lens into it [in "
        "macro three, defined at no_such_folder/s.sdl:1:1, used at no_such_folder/s.sdl:1:42]");
}

TEST_CASE("warnings inside a macro name where it was defined and used") {
  std::vector<std::string> warnings;
  (void)scene_of("def bright { diffuse 2 0 0 } use bright sphere diffuse 2 0 0", &warnings);
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].find("[in macro bright, defined at ") != std::string::npos);
  CHECK(warnings[1].find("[in macro") == std::string::npos);
}

TEST_CASE("errors of macros") {
  CHECK(scene_error("def a sphere") ==
        "s.sdl:1:7: \"sphere\" stands where { should (def takes NAME "
        "{ ... }). Put the macro's statements in braces");
  CHECK(scene_error("def a { def b { sphere }") ==
        "s.sdl:1:7: the brace of macro a is not closed (the end of the file comes before). Add } "
        "after the macro's statements");
  CHECK(scene_error("def {") ==
        "s.sdl:1:5: \"{\" stands where the name of a macro should (def takes "
        "NAME { ... }). Give a name; one with spaces goes in double quotes");
  CHECK(scene_error("def pawn { sphere } use pwan") ==
        "s.sdl:1:25: unknown macro \"pwan\" (no def before it has this name). Did you mean pawn?");
  CHECK(scene_error("use pawn") == "s.sdl:1:5: unknown macro \"pawn\" (no def before it has this "
                                   "name). Define it with def, before its use");
  CHECK(
      scene_error("def a { use b } def b { use A } use a")
          .find("s.sdl:1:29: macro a uses itself (a uses b uses a). Remove this use [in macro b") ==
      0);
  std::string chain = "def m0 { sphere }";
  for (int i = 1; i <= 300; ++i)
    chain += " def m" + std::to_string(i) + " { use m" + std::to_string(i - 1) + " }";
  CHECK(scene_error(chain + " use m300")
            .find("too many macros and files inside each other (at most "
                  "200 are read). Nest fewer of them") != std::string::npos);
}

TEST_CASE("an included file is found from the file that names it") {
  const Folder folder;
  folder.write("main.sdl", "translate 5 0 0 include parts/a.sdl use ball");
  folder.write("parts/a.sdl", "include \"b.sdl\" translate 1 0 0 cube");
  folder.write("parts/b.sdl", "def ball { sphere } use ball");
  const Scene scene = read_scene(folder.path / "main.sdl", {});
  REQUIRE(scene.shapes.size() == 3);
  CHECK(x_of(scene, 0) == 5.0);
  CHECK(x_of(scene, 1) == 6.0);
  CHECK(std::holds_alternative<Sphere>(scene.shapes[2].shape));
}

TEST_CASE("errors of included files") {
  const Folder folder;
  folder.write("missing.sdl", "\ninclude parts/no.sdl");
  CHECK(folder.error("missing.sdl") ==
        "missing.sdl:2:9: there is no file \"parts/no.sdl\" (files are found relative to the one "
        "that includes them). Check the name, or write the whole path");
  folder.write("a.sdl", "include parts/b.sdl");
  folder.write("parts/b.sdl", "sphere\ninclude ../a.sdl");
  CHECK(folder.error("a.sdl") == "parts/b.sdl:2:9: \"parts/../a.sdl\" includes itself (it is being "
                                 "read already). Remove this include [included at a.sdl:1:9]");
  folder.write("typo.sdl", "include parts/typo.sdl");
  folder.write("parts/typo.sdl", "shpere");
  CHECK(folder.error("typo.sdl") ==
        "parts/typo.sdl:1:1: unknown keyword \"shpere\" (no such word in the scene language). Did "
        "you mean sphere? [included at typo.sdl:1:9]");
}
