#include "io/meshes/read_obj.h"

#include "tests/catch.h"
#include "tests/io/meshes/random_polygons.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

using namespace abbe;

namespace {

Polygons read(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  return read_obj(text, "m.obj", [&](const std::string& message) {
    REQUIRE(warnings != nullptr);
    warnings->push_back(message);
  });
}

std::string error(const std::string& text) {
  try {
    (void)read(text);
  } catch (const ReadError& fault) {
    return fault.what();
  }
  return "no error";
}

/// One of the ways to write a number so that it comes back.
std::string written(std::mt19937_64& random, double value) {
  std::string text;
  switch (random() % 4) {
  case 0:
    text = fmt::format("{}", value); // the shortest one
    break;
  case 1:
    text = fmt::format("{:.17g}", value);
    break;
  case 2:
    text = fmt::format("{:.16E}", value);
    break;
  default:
    text = fmt::format("{:.30e}", value);
  }
  if (random() % 2 == 0 && text.starts_with("0.")) text.erase(0, 1);
  if (random() % 2 == 0 && text.starts_with("-0.")) text.erase(1, 1);
  const bool plus = text[0] != '-' && random() % 4 == 0;
  return (plus ? "+" : "") + text;
}

std::string corner(std::mt19937_64& random, std::int32_t number, std::size_t vertices) {
  const std::int64_t from_end = number - static_cast<std::int64_t>(vertices);
  const std::string v = std::to_string(random() % 2 == 0 ? number + 1 : from_end);
  switch (random() % 4) {
  case 0:
    return v + "/1";
  case 1:
    return v + "//1";
  case 2:
    return v + "/1/-1";
  default:
    return v;
  }
}

/// The mesh as OBJ, with all that may stand between.
std::string obj_of(std::mt19937_64& random, const Polygons& mesh) {
  const std::string end = std::vector<std::string>{"\n", "\r\n", "\r"}[random() % 3];
  const auto gap = [&] {
    const std::vector<std::string> gaps{" ", "\t", "  ", " \\" + end, "\\" + end};
    return gaps[random() % gaps.size()];
  };
  const auto noise = [&] {
    const std::vector<std::string> lines{"",         "# v 1 2 3",      "g a b",       "usemtl f\\1",
                                         "s off",    "vn 0 0 1",       "vt 0.5 0.25", "  ",
                                         "o name  ", "mtllib none.mtl"};
    return random() % 3 == 0 ? lines[random() % lines.size()] + end : "";
  };
  std::string text = random() % 4 == 0 ? "\xEF\xBB\xBF" : "";
  for (const glm::dvec3& p : mesh.vertices) {
    text += noise() + "v";
    for (int axis = 0; axis < 3; ++axis)
      text += gap() + written(random, p[axis]);
    text += std::vector<std::string>{"", " ", " 1.0", " 0.5 0.5 0.5", "# here"}[random() % 4] + end;
  }
  std::size_t begin = 0;
  for (const std::size_t stop : mesh.ends) {
    text += noise() + "f";
    for (; begin < stop; ++begin)
      text += gap() + corner(random, mesh.corners[begin], mesh.vertices.size());
    text += end;
  }
  if (random() % 2 == 0) text.erase(text.size() - end.size()); // the last line is not ended
  return text;
}

} // namespace

TEST_CASE("meshes written in all ways of OBJ come back bit by bit") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 600; ++i) {
    const Polygons mesh = test::random_polygons(random, i % 2 == 0);
    const std::string text = obj_of(random, mesh);
    INFO(text);
    REQUIRE(test::same(read(text), mesh));
  }
}

TEST_CASE("decimals become the nearest doubles") {
  std::mt19937_64 random(6);
  for (int i = 0; i < 20000; ++i) { // as strtod of the C library rounds them
    const std::string text =
        fmt::format("{}.{}e{}", random() % 100, random(), static_cast<int>(random() % 660) - 350);
    const double expected = std::strtod(text.c_str(), nullptr);
    if (!std::isfinite(expected)) {
      CHECK(error("v " + text + " 0 0").find("finite") != std::string::npos);
      continue;
    }
    REQUIRE(read("v " + text + " 0 0").vertices[0].x == expected);
  }
  CHECK(read("v 1e-400 -1e-400 0.000e999").vertices[0] == glm::dvec3(0.0));
  CHECK(read("v .5 -.5 +5.").vertices[0] == glm::dvec3(0.5, -0.5, 5.0));
  CHECK(error("v 1e400 0 0") ==
        "m.obj:1:3: \"1e400\" is not a coordinate that is finite (no such thing can stand here). "
        "Write the mesh again");
}

TEST_CASE("vertices may come after the faces that name them, and colours are left out") {
  const Polygons mesh = read("f 1 2 3\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0.5\n");
  CHECK(mesh.vertices.size() == 3);
  CHECK(mesh.corners == std::vector<std::int32_t>{0, 1, 2});
}

TEST_CASE("errors in OBJ name the place") {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string again = " Write the mesh again";
  CHECK(error("v 0 0\n") ==
        "m.obj:1:6: the line ends where a coordinate should stand (something is "
        "missing)." +
            again);
  CHECK(error("v 0 0") == "m.obj:1:6: the file ends where a coordinate should stand (something is "
                          "missing)." +
                              again);
  CHECK(error("\r\n\rv 0 x\x1B"
              "0 0") == "m.obj:3:5: \"x\\x1b0\" is not a coordinate (no such thing "
                        "can stand here)." +
                            again);
  CHECK(error("v nan 0 0").find("m.obj:1:3: \"nan\" is not a coordinate that is finite") == 0);
  CHECK(error("v 0x10 0 0").find("m.obj:1:3: \"0x10\" is not a coordinate (") == 0);
  CHECK(error("v 0 0 0 " + std::string(100, 'x')).find('"' + std::string(40, 'x') + "...\"") !=
        std::string::npos);
  CHECK(error(v + "f 1 2 4\n") == "m.obj:4:7: \"4\" names no vertex (there are 3 vertices up to "
                                  "here, and they count from 1)." +
                                      again);
  CHECK(error(v + "f 1 2 -4\n").find("m.obj:4:7: \"-4\" names no vertex") == 0);
  CHECK(error(v + "f 0 1 2\n").find("m.obj:4:3: \"0\" names no vertex") == 0);
  CHECK(error(v + "f 1 2\n") ==
        "m.obj:4:6: the face ends after 2 corners (a face has three or more)." + again);
  CHECK(error(v + "f 1 2 3/\n").find("no error") == 0);
  CHECK(error(v + "f 1 2 3.5\n") ==
        "m.obj:4:7: \"3.5\" is no corner (corners are v, v/vt, v//vn or v/vt/vn)." + again);
  CHECK(error(v + "f 1 2 3/1/1/1\n").find("m.obj:4:7: \"3/1/1/1\" is no corner") == 0);
  CHECK(error(v + "f 1 2 99999999999999999999\n").find("m.obj:4:7: ") == 0);
}

TEST_CASE("what is no statement of OBJ is left out with one warning") {
  std::vector<std::string> warnings;
  const Polygons mesh = read("v 0 0 0\nsurf 0 1 0 1\nv 1 0 0\nfoo\nv 0 1 0\nf 1 2 3", &warnings);
  CHECK(mesh.vertices.size() == 3);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == "m.obj:2:1: \"surf\" is left out (it is no statement that makes a mesh), "
                       "and 1 more like it");
}

TEST_CASE("a face of a million corners is one line") {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 1000000; ++i)
    text += i % 3 == 0 ? " 1" : i % 3 == 1 ? " 2" : " 3";
  CHECK(read(text).corners.size() == 1000000);
}
