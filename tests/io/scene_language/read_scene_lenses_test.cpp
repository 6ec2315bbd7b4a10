#include "tests/io/scene_language/read_scene_helpers.h"

#include "tests/catch.h"

using namespace abbe;

TEST_CASE("a lens element by its data, with the current material") {
  const Scene scene = scene_of("glass N-BK7 lensElement 10 -20 2 6 lensElement INF 0 1 6 4\n"
                               "translate 0 0 10 lensElement 10 -20 2 6");
  REQUIRE(scene.shapes.size() == 3);
  CHECK(scene.media.size() == 1);
  CHECK(contains(scene.shapes[0], {0, 0, 0.01}));
  CHECK(contains(scene.shapes[0], {0, 0, 1.99}));
  CHECK_FALSE(contains(scene.shapes[0], {0, 0, -0.01}));
  CHECK_FALSE(contains(scene.shapes[0], {0, 2.9, 0.1})); // the front bends towards +z
  CHECK(contains(scene.shapes[1], {0, 2.9, 4.01}));
  CHECK(contains(scene.shapes[2], {0, 0, 11}));
}

TEST_CASE("a lens element as an operand") {
  const Scene scene = scene_of("glass N-BK7 difference lensElement 10 -20 2 6\n"
                               "  push translate 0 0 -5 scale 1 1 10 reflectivity 0 cylinder pop");
  REQUIRE(scene.shapes.size() == 1);
  CHECK_FALSE(contains(scene.shapes[0], {0, 0, 1}));
  CHECK(contains(scene.shapes[0], {2, 0, 1}));
  const auto& leaves = std::get<CsgTree>(scene.shapes[0].shape).leaves();
  CHECK_FALSE(leaves.at(0).material.valid());
  CHECK(leaves.back().material.valid());
  CHECK(contains(scene_of("union sphere push translate 0 0 9 lensElement 10 -20 2 6 pop").shapes[0],
                 {0, 0, 10}));
}

TEST_CASE("cemented elements stand one behind the other, each with its glass") {
  const Scene scene = scene_of("diffuse 0 1 0 translate 0 0 100\n"
                               "cemented 3 25.4  33.34 N-BAF10 9  -22.28 SF10 2.5  inf N-BK7 3  0\n"
                               "sphere");
  REQUIRE(scene.shapes.size() == 4);
  const double inside[] = {104, 110, 113};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(contains(scene.shapes[i], {0, 0, inside[k]}) == (i == k));
  const char* const names[] = {"N-BAF10", "SF10", "N-BK7"};
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(scene.media.at(scene.shapes[i].medium.index()).name == names[i]);
  CHECK_FALSE(scene.shapes[3].medium.valid()); // the material before stays
}

TEST_CASE("errors of lenses") {
  CHECK(scene_error("lensElement 10 -20 0 6") ==
        "s.sdl:1:20: 0 is out of range for lensElement (it is the thickness on the axis). Give a "
        "number more than 0");
  CHECK(scene_error("lensElement 10 -20 2 -6") ==
        "s.sdl:1:22: -6 is out of range for lensElement (it is the diameter). Give a number more "
        "than 0");
  CHECK(scene_error("lensElement 10 flat") ==
        "s.sdl:1:16: \"flat\" is not a number (lensElement takes R1 R2 thickness diameter [z]). "
        "Give a finite number such as 2, -0.5 or 1e-3");
  const std::string hint = "). Check the signs of the radii, the thickness and the diameter";
  CHECK(scene_error("lensElement 2 0 5 6") ==
        "s.sdl:1:1: these data describe no lens (a radius of curvature is less than half of the "
        "diameter" +
            hint);
  CHECK(scene_error("lensElement 10 -10 0.5 6") ==
        "s.sdl:1:1: these data describe no lens (its surfaces cross inside the diameter" + hint);
  CHECK(scene_error("lensElement 3 0 4 6") ==
        "s.sdl:1:1: these data describe no lens (it is thicker than the ball that a convex surface "
        "belongs to" +
            hint);
  CHECK(scene_error("cemented 1 6") ==
        "s.sdl:1:10: 1 is out of range for cemented (it is the number of elements). Give a number "
        "from 2 to 16");
  CHECK(scene_error("cemented 2 6  10 N-BK7 2  -10 broth")
            .find("s.sdl:1:31: unknown glass \"broth\" (no such name in the glass catalogue)") ==
        0);
  CHECK(scene_error("cemented 2 6  10 N-BK7 2  -10 SF10 0.1 -3") ==
        "s.sdl:1:31: these data describe no lens (its surfaces cross inside the diameter" + hint);
  CHECK(scene_error("union cemented 2 6") ==
        "s.sdl:1:7: cemented cannot stand inside union (only solids, transforms and materials "
        "can). Move it before union");
}
