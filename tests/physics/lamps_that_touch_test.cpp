#include "tests/catch.h"
#include "tests/seeds.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

using namespace abbe;

namespace {

/// A scene in and about a cube of side 10, moved and scaled as a whole.
struct Placed {
  double scale = 1.0;
  dvec3 offset{0.0};

  [[nodiscard]] std::string point(double x, double y, double z) const {
    const dvec3 p = offset + scale * dvec3{x, y, z};
    return fmt::format("{} {} {} ", p.x, p.y, p.z);
  }
  /// Where the camera stands, and all that follows.
  [[nodiscard]] std::string start(const std::string& settings) const {
    return "integrator path " + settings + " imageSize 24 24 fieldOfView 50 background 0 0 0\n" +
           "eye " + point(0.0, 1.2, 4.0) + "lookAt " + point(0.0, -1.0, 0.0) + "\n" +
           fmt::format("translate {} {} {} scale {} {} {}\n", offset.x, offset.y, offset.z, scale,
                       scale, scale) +
           "ambient 0 0 0 specular 0 0 0 diffuse 0.8 0.8 0.8\n"
           "push translate 0 -1 0 rotate -90 1 0 0 scale 5 5 1 square pop\n";
  }
};

const Placed kPlaces[] = {{}, {1e-4, {}}, {3.7, {}}, {1.0, {1000.0, 700.0, -300.0}}};

} // namespace

TEST_CASE("a lamp on a face of glass lights the same wherever and however large the scene is") {
  std::vector<test::SeedStatistics> seen;
  for (const Placed& placed : kPlaces) {
    const Scene scene = test::scene_from(
        placed.start("samples 32") +
        "rotate 25 1 2 3 emissive 5 5 5\n"
        "push translate 0 0.5 0 rotate 90 1 0 0 scale 0.3 0.3 1 square pop\n"
        "emissive 0 0 0 glass N-BK7 push translate 0 0.2 0 scale 0.3 0.3 0.3 cube pop");
    seen.push_back(test::over_seeds(scene, 12));
    CAPTURE(placed.scale, seen.back().total, std::sqrt(seen.back().total_variance));
    CHECK(std::abs(total_z(seen.back(), seen.front())) < 4.0);
    CHECK(std::sqrt(seen.back().total_variance) < 0.02 * seen.back().total);
  }
}

TEST_CASE("a lamp on a black card lights as one that stands a hair before it") {
  // Scenes on which the lamp's and the card's planes coincide but for rounding.
  for (const Placed& placed : kPlaces) {
    test::SeedStatistics seen[2];
    for (int i = 0; i < 2; ++i) {
      const Scene scene = test::scene_from(
          placed.start("maxRecursionDepth 12 samples 16") +
          "glass N-BK7 push translate 0 0.2 0 scale 0.7 0.7 0.7 sphere pop\n"
          "defaultMaterials ambient 0 0 0 specular 0 0 0 diffuse 0 0 0\n"
          "push rotate 200 0 1 0 translate 0.1 0.5 2.27 push scale 2 1.2 1 square pop\n"
          "emissive 4 4 4 emissiveSides front\n" +
          fmt::format("push translate 0 0.3 {} rotate 180 0 1 0 scale 0.25 0.9 1 square pop pop",
                      i == 0 ? "0" : "-0.0001"));
      seen[i] = test::over_seeds(scene, 12);
    }
    CAPTURE(placed.scale, seen[0].total, seen[1].total);
    CHECK(std::abs(total_z(seen[0], seen[1])) < 4.0);
    CHECK(mean_square_z(seen[0], seen[1]) < 1.6);
  }
}

TEST_CASE("a lamp that is covered lights nothing") {
  for (const Placed& placed : kPlaces)
    for (const std::string lamp : {"square", "cube", "sphere", "disc"}) {
      const Scene scene = test::scene_from(
          placed.start("samples 16") +
          "push rotate 25 1 2 3 translate 0 1 0.3 scale 0.5 0.5 0.5 emissive 5 5 5\n" + lamp +
          "\nemissive 0 0 0 diffuse 0 0 0\n" + lamp + " pop");
      CAPTURE(placed.scale, lamp);
      CHECK(test::over_seeds(scene, 2).total == 0.0);
    }
}

TEST_CASE("half a lamp that is covered lights as the other half alone") {
  const Placed placed;
  const std::string before =
      placed.start("samples 32") + "push translate 0 1 0 rotate 90 1 0 0 emissive 5 5 5\n";
  const auto covered = test::over_seeds(
      test::scene_from(before + "square emissive 0 0 0 diffuse 0 0 0\n"
                                "push translate 1.5 0 0 scale 1.5 1.5 1 square pop pop"),
      8);
  const auto half = test::over_seeds(
      test::scene_from(before + "push translate -0.5 0 0 scale 0.5 1 1 square pop\n"
                                "emissive 0 0 0 diffuse 0 0 0\n"
                                "push translate 1.5 0 0 scale 1.5 1.5 1 square pop pop"),
      8);
  CHECK(half.total > 0.1);
  CHECK(std::abs(total_z(covered, half)) < 4.0);
  CHECK(mean_square_z(covered, half) < 1.6);
}
