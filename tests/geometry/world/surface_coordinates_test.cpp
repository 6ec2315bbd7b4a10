#include "geometry/world/surface_coordinates.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

void check(const dvec2& uv, double u, double v) {
  CHECK(uv.x == Approx(u).margin(1e-12));
  CHECK(uv.y == Approx(v).margin(1e-12));
}

PlacedShape placed(Shape shape, const Transform& to_world = {}) {
  return {std::move(shape), to_world, {}, {}, 0};
}

dvec2 at(const Shape& shape, int face, const dvec3& point) {
  return surface_coordinates(placed(shape), {0, face}, point);
}

} // namespace

TEST_CASE("square, disc and plane have x and y, with the square as 0 to 1") {
  for (const Shape& shape : {Shape(Square{}), Shape(Disc{}), Shape(Plane{})}) {
    check(at(shape, 0, {-1, -1, 0}), 0, 0);
    check(at(shape, 0, {0.5, -0.5, 0}), 0.75, 0.25);
  }
  check(at(Plane{}, 0, {3, -5, 0}), 2, -2);
}

TEST_CASE("surface coordinates are those of the shape before its transforms") {
  const Transform move = Transform::translation({5, 6, 7}).after(
      Transform::rotation(90, {1, 0, 0}).after(Transform::scaling({4, 2, 1})));
  // (0.5, -0.5, 0) is scaled to (2, -1, 0), turned to (2, 0, -1).
  check(surface_coordinates(placed(Square{}, move), {}, {7, 6, 6}), 0.75, 0.25);
}

TEST_CASE("sphere: longitude in turns and latitude") {
  const double r = std::sqrt(0.5);
  check(at(Sphere{}, 0, {1, 0, 0}), 0.0, 0.5);
  check(at(Sphere{}, 0, {0, 1, 0}), 0.25, 0.5);
  check(at(Sphere{}, 0, {-1, 0, 0}), 0.5, 0.5);
  check(at(Sphere{}, 0, {0, -1, 0}), 0.75, 0.5);
  check(at(Sphere{}, 0, {0, r, r}), 0.25, 0.75);
  check(at(Sphere{}, 0, {0, -r, -r}), 0.75, 0.25);
  CHECK(at(Sphere{}, 0, {0, 0, 1}).y == 1.0);
  CHECK(at(Sphere{}, 0, {0, 0, -1}).y == 0.0);
  // Just below +x: the whole turn itself does not occur.
  const double u = at(Sphere{}, 0, {1, -1e-300, 0}).x;
  CHECK((u >= 0.0 && u < 1.0));
}

TEST_CASE("each face of the box has 0 to 1, to the right and up as seen from outside") {
  for (int face = 0; face < 6; ++face) {
    dvec3 normal{0.0};
    normal[face / 2] = face % 2 == 1 ? 1.0 : -1.0;
    const dvec3 up = face < 4 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
    const dvec3 right = glm::cross(up, normal); // for one who looks along -normal
    INFO("face " << face);
    check(at(Box{}, face, normal), 0.5, 0.5);
    check(at(Box{}, face, normal + 0.5 * right), 0.75, 0.5);
    check(at(Box{}, face, normal + 0.5 * up - right), 0.0, 0.75);
  }
}

TEST_CASE("cylinder and cone: angle and height on the side, a disc on the ends") {
  for (const double top : {1.0, 0.5, 0.0}) {
    const TaperedCylinder solid{top};
    const double r = 1.0 + 0.25 * (top - 1.0);
    check(at(solid, 0, {0, r, 0.25}), 0.25, 0.25);
    check(at(solid, 0, {-r, 0, 0.25}), 0.5, 0.25);
    check(at(solid, 1, {0.5, 0.5, 0}), 0.25, 0.75); // from below, x runs to the left
  }
  check(at(TaperedCylinder{1.0}, 2, {0.5, 0.5, 1}), 0.75, 0.75);
}

TEST_CASE("polyhedra and meshes have the coordinates of the box's face they look at") {
  // A roof: the triangle over y = 1 that looks mostly along +z.
  const Mesh roof({{-1, -1, 0}, {1, -1, 0}, {1, 1, 1}, {-1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}});
  check(at(roof, 0, {0.5, 0, 0.5}), 0.75, 0.5);
  check(at(roof, 1, {-0.5, 0, 0.5}), 0.25, 0.5);
  const Mesh wall({{2, -1, -1}, {2, 1, -1}, {2, 1, 1}}, {{0, 1, 2}});
  check(at(wall, 0, {2, 0.5, 0}), 0.75, 0.5);

  const ConvexPolyhedron prism = thesis_prism();
  for (int face = 0; face < 5; ++face) {
    const dvec3 n = outward_normal(prism, {}, face);
    const dvec3 point{0.25, 0.125, -0.5}; // wherever it is: only the projection counts
    INFO("face " << face);
    if (std::abs(n.y) > 0.9) check(at(prism, face, point), n.y > 0 ? 0.375 : 0.625, 0.25);
    if (n.z > 0.9) check(at(prism, face, point), 0.625, 0.5625);
    if (std::abs(n.x) > 0.7) check(at(prism, face, point), n.x > 0 ? 0.5625 : 0.4375, 0.25);
  }
}

TEST_CASE("an operand of a boolean has its own coordinates") {
  const CsgTree tree(CsgOperation::unite, CsgTree(Box{}, {}),
                     CsgTree(Sphere{}, Transform::translation({3, 0, 0})));
  check(surface_coordinates(placed(tree), {0, 5}, {0.5, 0, 1}), 0.75, 0.5);
  check(surface_coordinates(placed(tree, Transform::translation({0, 7, 0})), {1, 0}, {3, 8, 0}),
        0.25, 0.5);
}
