// Bodies of glass from mesh files with the usual faults look as a sound body does.

#include "tests/catch.h"
#include "tests/io/temporary_folder.h"
#include "tests/render_text.h"

#include <fstream>
#include <string>
#include <vector>

using namespace abbe;

namespace {

struct Body {
  std::string name, obj;
};

const std::string kCorners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                             "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string kSides = "f 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\n";

/// The cube from -1 to 1, each time with another fault.
std::vector<Body> faulty_cubes() {
  return {
      {"turned", kCorners + kSides + "f 1 4 3 2\nf 5 6 7 8\nf 1 4 8 5\n"},
      {"t_junction", kCorners + kSides +
                         "v 0 -1 1\nv 0 1 1\nf 1 4 3 2\nf 4 1 5 8\n"
                         "f 5 9 10 8\nf 9 6 7 10\n"},
      {"seam", kCorners + kSides +
                   "v -1 -1 1.0000002\nv 1 -1 1\nv 1.0000002 1 1\nv -1 1.0000001 1\n"
                   "f 1 4 3 2\nf 4 1 5 8\nf 9 10 11 12\n"},
      {"two", kCorners +
                  "v -1 -1 0.25\nv 1 -1 0.25\nv 1 1 0.25\nv -1 1 0.25\n" // with a wall between
                  "f 1 4 3 2\nf 9 10 11 12\nf 1 2 10 9\nf 2 3 11 10\nf 3 4 12 11\nf 4 1 9 12\n"
                  "f 10 9 12 11\nf 5 6 7 8\nf 9 10 6 5\nf 10 11 7 6\nf 11 12 8 7\nf 12 9 5 8\n"},
  };
}

double mean_y(const Rendering& r, int size) {
  double sum = 0.0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      sum += r.film.color(x, y).y / (size * size);
  return sum;
}

} // namespace

TEST_CASE("glass of a mended mesh passes what a slab of glass passes") {
  const test::Folder folder;
  const auto scene = [&](const std::string& view, const std::string& shape) {
    return test::evenly_sampled(
        read_scene_text("imageSize 8 8 samples 4 bands 3 minThroughput 0 " + view +
                            " defaultMaterials ambient 0 0 0 diffuse 0 0 0 emissive E 1 "
                            "push translate 0.3 0 -4 scale 3 3 1 square pop "
                            "speedOfLight 1.5 reflectivity 1 transparency 1 emissive 0 0 0 " +
                            shape,
                        folder.path / "s.sdl", {}));
  };
  // Against the light, along the axis: R = 0.04 at each side, and the reflections between the two
  // sides add up to (1 - R) / (1 + R). What leaves towards the eye's side meets nothing.
  const std::string straight = "eye 0 0 900 lookAt 0 0 0 fieldOfView 0.05";
  const std::string oblique = "eye 4.2 3.6 7 lookAt 0 0 0 fieldOfView 22";
  const Rendering sound = test::render_scene(scene(oblique, "cube"), false);
  REQUIRE(mean_y(sound, 8) > 0.05);
  for (const auto& [name, obj] : faulty_cubes()) {
    INFO(name);
    std::ofstream(folder.path / (name + ".obj")) << obj;
    const Rendering front = test::render_scene(scene(straight, "mesh " + name + ".obj"), false);
    CHECK(mean_y(front, 8) == Approx(0.96 / 1.04).epsilon(1e-4));
    const Rendering mended = test::render_scene(scene(oblique, "mesh " + name + ".obj"), false);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        CHECK(mended.film.color(x, y).y == Approx(sound.film.color(x, y).y).margin(1e-3));
  }
}
