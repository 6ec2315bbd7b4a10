#include "tests/io/scene_language/read_scene_helpers.h"

#include "tests/catch.h"

#include <glm/geometric.hpp>

using namespace abbe;

namespace {

bool near(const dvec3& a, const dvec3& b) {
  return glm::length(a - b) < 1e-14;
}

const CsgTree& tree_of(const Scene& scene, std::size_t shape) {
  return std::get<CsgTree>(scene.shapes.at(shape).shape);
}

/// Whether the world point lies inside the scene's only shape.
bool inside(const Scene& scene, const dvec3& point) {
  return contains(scene.shapes.at(0), point);
}

} // namespace

TEST_CASE("every shape's keyword") {
  const Scene scene =
      scene_of("sphere Cube SQUARE prism cylinder cone taperedCylinder 0.5 disc plane");
  REQUIRE(scene.shapes.size() == 9);
  CHECK(std::get<TaperedCylinder>(scene.shapes[4].shape).top_radius == 1.0);
  CHECK(std::get<TaperedCylinder>(scene.shapes[5].shape).top_radius == 0.0);
  CHECK(std::get<TaperedCylinder>(scene.shapes[6].shape).top_radius == 0.5);
  CHECK(std::holds_alternative<Disc>(scene.shapes[7].shape));
  CHECK(std::holds_alternative<Plane>(scene.shapes[8].shape));
  CHECK(std::holds_alternative<Sphere>(scene.shapes[0].shape));
  CHECK(std::holds_alternative<Box>(scene.shapes[1].shape));
  CHECK(std::holds_alternative<Square>(scene.shapes[2].shape));
  CHECK(std::get<ConvexPolyhedron>(scene.shapes[3].shape).half_spaces().size() == 5);
}

TEST_CASE("the transform nearest to the shape acts first") {
  const Scene scene = scene_of("translate 10 0 0 rotate 90 0 0 1 scale 2 3 4 sphere");
  const Transform& t = scene.shapes.at(0).to_world;
  CHECK(near(t.point({1, 0, 0}), {10, 2, 0})); // scaled to 2, turned to y, moved
  CHECK(near(t.point({0, 1, 0}), {7, 0, 0}));
  CHECK(near(t.point({0, 0, 1}), {10, 0, 4}));
}

TEST_CASE("pop returns to the transform of its push, but not to the material") {
  const Scene scene = scene_of("translate 1 0 0 push translate 0 1 0 push translate 0 0 1\n"
                               "reflectivity 1 sphere pop sphere pop sphere");
  CHECK(near(scene.shapes.at(0).to_world.point({}), {1, 1, 1}));
  CHECK(near(scene.shapes.at(1).to_world.point({}), {1, 1, 0}));
  CHECK(near(scene.shapes.at(2).to_world.point({}), {1, 0, 0}));
  CHECK(scene.shapes.at(0).material == scene.shapes.at(2).material);
}

TEST_CASE("the thesis's lens is where both balls are") {
  const Scene scene =
      scene_of("glass N-BK7 lens sphere push translate 1 0 0 sphere pop defaultMaterials cube");
  REQUIRE(scene.shapes.size() == 2);
  CHECK(inside(scene, {0.5, 0, 0}));
  CHECK_FALSE(inside(scene, {-0.5, 0, 0}));
  CHECK_FALSE(inside(scene, {1.5, 0, 0}));
  CHECK(scene.media.at(scene.shapes[0].medium.index()).name == "N-BK7");
  for (const CsgLeaf& leaf : tree_of(scene, 0).leaves())
    CHECK_FALSE(leaf.material.valid());
  CHECK(near(scene.shapes[1].to_world.point({}), {0, 0, 0}));
}

TEST_CASE("a boolean stands where the transform at its keyword puts it") {
  const Scene scene =
      scene_of("translate 0 5 0 rotate 90 0 0 1 lens sphere push translate 1 0 0 sphere pop cube");
  CHECK(inside(scene, {0, 5.5, 0}));
  CHECK_FALSE(inside(scene, {0, 4.5, 0}));
  CHECK(near(scene.shapes.at(1).to_world.point({1, 0, 0}), {0, 6, 0}));
}

TEST_CASE("union, intersection and difference") {
  const std::string operands = " cube push translate 1 0 0 cube pop";
  const dvec3 left{-0.5, 0, 0}, middle{0.5, 0, 0}, right{1.5, 0, 0};
  const Scene sum = scene_of("union" + operands);
  CHECK((inside(sum, left) && inside(sum, middle) && inside(sum, right)));
  const Scene common = scene_of("intersection" + operands);
  CHECK((!inside(common, left) && inside(common, middle) && !inside(common, right)));
  const Scene rest = scene_of("difference" + operands);
  CHECK((inside(rest, left) && !inside(rest, middle) && !inside(rest, right)));
}

TEST_CASE("booleans nest, as either operand") {
  // A cube without the lens at its corner, and a ball beside it.
  const Scene scene = scene_of("union\n"
                               "  push difference\n"
                               "    cube\n"
                               "    push translate 1 1 1 intersection sphere sphere pop\n"
                               "  pop\n"
                               "  push translate 5 0 0 sphere pop\n"
                               "square");
  REQUIRE(scene.shapes.size() == 2);
  CHECK(tree_of(scene, 0).leaves().size() == 4);
  CHECK(inside(scene, {0, 0, 0}));
  CHECK_FALSE(inside(scene, {0.9, 0.9, 0.9}));
  CHECK(inside(scene, {5.5, 0, 0}));
  const Scene right = scene_of("difference cube difference cube sphere");
  CHECK(inside(right, {0, 0, 0}));
  CHECK_FALSE(inside(right, {0.9, 0.9, 0.9}));
}

TEST_CASE("one push may hold both operands; a transform without push stays, as everywhere") {
  const Scene scene = scene_of("lens push translate 3 0 0 sphere translate 1 0 0 sphere pop cube");
  CHECK(inside(scene, {3.5, 0, 0}));
  CHECK(near(scene.shapes.at(1).to_world.point({}), {0, 0, 0}));
  const Scene leaking = scene_of("translate 1 0 0 union sphere translate 0 1 0 sphere cube");
  CHECK(near(leaking.shapes.at(1).to_world.point({}), {1, 1, 0}));
}

TEST_CASE("a material inside an operand is that operand's finish only") {
  const Scene scene = scene_of("glass N-BK7\n"
                               "union\n"
                               "  push UseMaterial StrongOrangeYellow sphere pop\n"
                               "  difference cube push reflectivity 0 cube pop\n"
                               "sphere");
  const auto& leaves = tree_of(scene, 0).leaves();
  REQUIRE(leaves.size() == 3);
  CHECK(scene.materials.at(leaves[0].material.index()).name == "StrongOrangeYellow");
  CHECK_FALSE(leaves[1].material.valid());
  REQUIRE(leaves[2].material.valid());
  CHECK(scene.materials.at(leaves[2].material.index()).reflectivity.constant_value() == 0.0);
  CHECK(scene.materials.at(scene.shapes.at(0).material.index()).name == "N-BK7");
  CHECK(scene.materials.at(scene.shapes.at(1).material.index()).name == "N-BK7");
  CHECK(scene.media.size() == 1);
}

TEST_CASE("a material before a nested boolean is the finish of all its operands") {
  const Scene scene = scene_of("union UseMaterial StrongOrangeYellow difference cube sphere cube");
  const auto& leaves = tree_of(scene, 0).leaves();
  CHECK(leaves.at(0).material.valid());
  CHECK(leaves.at(0).material == leaves.at(1).material);
  CHECK_FALSE(leaves.at(2).material.valid());
}

TEST_CASE("an operand with another filling than its boolean warns") {
  std::vector<std::string> warnings;
  (void)scene_of("glass N-BK7 lens sphere glass N-SF11 sphere", &warnings);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("test.sdl:1:38: what fills this operand is ignored (one medium fills the "
                         "whole solid, that of the outermost boolean)") != std::string::npos);
}

TEST_CASE("a polyhedron by planes and by vertices") {
  // The same tetrahedron, twice; normals may have any length.
  const Scene scene =
      scene_of("glass N-BK7\n"
               "polyhedron planes 4  -2 0 0 0  0 -1 0 0  0 0 -1 0  1 1 1 1\n"
               "difference polyhedron vertices 5  0 0 0  1 0 0  0 1 0  0 0 1  0.1 0.1 0.1 sphere");
  REQUIRE(scene.shapes.size() == 2);
  const auto& by_planes = std::get<ConvexPolyhedron>(scene.shapes[0].shape);
  const auto& by_vertices = std::get<ConvexPolyhedron>(tree_of(scene, 1).leaves().at(0).solid);
  CHECK(by_planes.vertices().size() == 4);
  CHECK(by_vertices.half_spaces().size() == 4);
  for (const dvec3& v : by_planes.vertices())
    CHECK(std::abs(signed_distance(by_vertices, v)) < 1e-15);
}

TEST_CASE("errors of shapes") {
  CHECK(scene_error("taperedCylinder -1") ==
        "s.sdl:1:17: -1 is out of range for taperedCylinder (it is the radius at z = 1). Give a "
        "number 0 or more");
  for (const std::string flat : {"disc", "plane"})
    CHECK(scene_error("union cube " + flat) ==
          "s.sdl:1:12: " + flat +
              " cannot be an operand (it has no inside to combine). Use a flat "
              "cube, or another solid");
  CHECK(scene_error("polyhedron corners 4") ==
        "s.sdl:1:12: \"corners\" is no choice of polyhedron (polyhedron takes planes|vertices n "
        "...). Give planes or vertices");
  CHECK(scene_error("polyhedron planes 3") ==
        "s.sdl:1:19: 3 is out of range for polyhedron (it is the number of planes). Give a number "
        "from 4 to 256");
  CHECK(scene_error("polyhedron vertices 129") ==
        "s.sdl:1:21: 129 is out of range for polyhedron (it is the number of vertices). Give a "
        "number from 4 to 128");
  CHECK(scene_error("polyhedron planes 4  1 0 0 1  0 0 0 1") ==
        "s.sdl:1:31: a plane's normal has no direction (it is 0 0 0). Give the direction in which "
        "the plane looks outwards");
  CHECK(scene_error("polyhedron planes 4  1 0 0 1  -1 0 0 1  0 1 0 1  0 -1 0 1") ==
        "s.sdl:1:1: this polyhedron is no solid (the planes leave the solid open to infinity). "
        "Give planes that look outwards on all sides of a point");
  CHECK(scene_error("polyhedron planes 4  -1 0 0 0  0 -1 0 0  0 0 -1 0  1 1 1 -1") ==
        "s.sdl:1:1: this polyhedron is no solid (the planes enclose no volume). Give planes that "
        "look outwards on all sides of a point");
  CHECK(scene_error("polyhedron vertices 4  0 0 0  1 0 0  0 1 0  1 1 0") ==
        "s.sdl:1:1: this polyhedron is no solid (the vertices lie in one plane). Give vertices "
        "that do not lie in one plane");
  CHECK(scene_error("polyhedron vertices 4  0 0 0  1 0 0  2 0 0  3 0 0") ==
        "s.sdl:1:1: this polyhedron is no solid (the vertices lie on one line). Give vertices that "
        "do not lie in one plane");
}

TEST_CASE("errors of transforms") {
  CHECK(scene_error("rotate 10 0 0 0") == "s.sdl:1:11: the axis of rotate has no direction (it is "
                                          "0 0 0). Give an axis such as 0 1 0");
  CHECK(scene_error("scale 1 0 1") ==
        "s.sdl:1:9: a factor of scale is 0 (a flattened shape has no inside and no way back). Give "
        "a factor other than 0");
  CHECK(scene_error("sphere pop") == "s.sdl:1:8: pop has no push (no transform is left to return "
                                     "to). Remove it, or add a push before");
  CHECK(scene_error("push\npush sphere pop") ==
        "s.sdl:1:1: push has no pop (the file ends before it). Add a pop after the shapes it is "
        "meant for");
}

TEST_CASE("an axis of any length turns") {
  CHECK(near(scene_of("rotate 90 0 0 1e200 sphere").shapes.at(0).to_world.point({1, 0, 0}),
             {0, 1, 0}));
  CHECK(near(scene_of("rotate 90 0 0 1e-200 sphere").shapes.at(0).to_world.point({1, 0, 0}),
             {0, 1, 0}));
}

TEST_CASE("numbers of an absurd size are errors with a position") {
  CHECK(scene_error("sphere scale 1e-150 1e-150 1e-150") ==
        "s.sdl:1:8: scale cannot be carried out (a transform that flattens space has no inverse). "
        "Give numbers of an ordinary size");
  CHECK(scene_error("translate 1e308 0 0 translate 1e308 0 0") ==
        "s.sdl:1:21: translate cannot be carried out (a transform that moves beyond the range of "
        "numbers). Give numbers of an ordinary size");
}

TEST_CASE("errors of booleans") {
  CHECK(scene_error("lens sphere") == "s.sdl:1:1: lens lacks an operand (the file ends after 1 of "
                                      "2 solids). Add a solid after it");
  CHECK(scene_error("union sphere\ndifference") ==
        "s.sdl:2:1: difference lacks an operand (the file ends after 0 of 2 solids). Add a solid "
        "after it");
  CHECK(scene_error("lens sphere push sphere sphere") ==
        "s.sdl:1:25: \"sphere\" stands where pop should (lens at line 1 has both operands, but not "
        "every push inside it has its pop). Add the pop");
  CHECK(scene_error("lens sphere push sphere") ==
        "s.sdl:1:24: the end of the file stands where pop should (lens at line 1 has both "
        "operands, but not every push inside it has its pop). Add the pop");
  CHECK(scene_error("push lens sphere pop sphere") ==
        "s.sdl:1:18: pop has no push inside lens (the operands of a boolean have their own push "
        "and pop). Add a push after lens");
  CHECK(scene_error("union cube square") ==
        "s.sdl:1:12: square cannot be an operand (it has no inside to combine). Use a flat cube, "
        "or another solid");
  CHECK(scene_error("union cube light E 0 0 0 1") ==
        "s.sdl:1:12: light cannot stand inside union (only solids, transforms and materials can). "
        "Move it before union");
  std::string nested;
  for (int i = 0; i < 100000; ++i)
    nested += "union ";
  CHECK(scene_error(nested) == "s.sdl:1:1201: too many booleans inside each other (at most 200 are "
                               "read). Combine fewer solids");
}
