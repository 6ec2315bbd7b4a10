#include "geometry/shape.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

using namespace abbe;

namespace {

ShapeState known(bool inside) {
  return {inside, false, {}};
}

ShapeState touching(int face, bool inside) {
  return {inside, true, {0, face}};
}

LocalRay along_z(double z, double error = 0.0) {
  return {{0, 0, z}, {0, 0, 1}, error};
}

} // namespace

TEST_CASE("next_crossing: a ray outside only enters, a ray inside only leaves") {
  for (const double z : {-3.0, -1.0}) {
    const auto in = next_crossing(Sphere{}, along_z(z), known(false));
    REQUIRE(in);
    REQUIRE(in->entering);
    REQUIRE(in->t == -1.0 - z);
  }
  REQUIRE_FALSE(next_crossing(Sphere{}, along_z(3.0), known(false)));
  REQUIRE_FALSE(next_crossing(Sphere{}, along_z(1.0), known(false)));
  const auto out = next_crossing(Sphere{}, along_z(0.0), known(true));
  REQUIRE(out);
  REQUIRE_FALSE(out->entering);
  REQUIRE(out->t == 1.0);
}

TEST_CASE("next_crossing: where rounding leaves no way out, it is at once") {
  // Known to be inside, though the line runs past, or the exit lies behind.
  const auto past = next_crossing(Sphere{}, {{1 + 1e-15, 0, 0}, {0, 0, 1}}, known(true));
  REQUIRE(past);
  REQUIRE(past->t == 0.0);
  REQUIRE_FALSE(past->entering);
  REQUIRE(next_crossing(Sphere{}, along_z(1.0 + 1e-15), known(true))->t == 0.0);
  const auto box = next_crossing(Box{}, {{1 + 1e-15, 0, 0}, {0, 0, 1}}, known(true));
  REQUIRE(box);
  REQUIRE(box->t == 0.0);
  REQUIRE(box->face.face == 1);
  // Even a direction that contradicts its contact: straight out through the face it should leave.
  const auto wrong = next_crossing(Box{}, {{1, 0, 0}, {1, 0, 0}}, touching(1, true));
  REQUIRE(wrong);
  REQUIRE(wrong->t == 0.0);
}

TEST_CASE("next_crossing: a solid entered a rounding before the origin is entered at once") {
  const auto in = next_crossing(Box{}, along_z(-1.0 + 1e-16, 1e-15), known(false));
  REQUIRE(in);
  REQUIRE(in->t == 0.0);
  REQUIRE(in->entering);
  REQUIRE_FALSE(next_crossing(Box{}, along_z(-1.0 + 1e-9, 1e-15), known(false)));
}

TEST_CASE("next_crossing: the touched face is not met again") {
  REQUIRE_FALSE(next_crossing(Box{}, along_z(1.0), touching(5, false)));
  REQUIRE(next_crossing(Box{}, along_z(-1.0), touching(4, true))->face.face == 5);
  REQUIRE_FALSE(next_crossing(Square{}, along_z(0.0), touching(0, false)));
  REQUIRE(next_crossing(Square{}, along_z(0.0), known(false))->t == 0.0);
}

TEST_CASE("next_crossing: a hollow ball from its hollow") {
  const CsgTree shell(CsgOperation::subtract, CsgTree(Sphere{}, Transform()),
                      CsgTree(Sphere{}, Transform::scaling(dvec3(0.5))));
  const auto in = next_crossing(shell, along_z(-0.5), {false, true, {1, 0}});
  REQUIRE(in);
  REQUIRE(in->entering);
  REQUIRE(in->t == 1.0);
  REQUIRE(in->face == FaceId{1, 0});
  const auto out = next_crossing(shell, along_z(0.5), {true, true, {1, 0}});
  REQUIRE(out);
  REQUIRE_FALSE(out->entering);
  REQUIRE(out->t == 0.5);
  REQUIRE(out->face == FaceId{0, 0});
  const auto across = next_crossing(shell, along_z(-1.0), {true, true, {0, 0}});
  REQUIRE(across);
  REQUIRE(across->t == 0.5);
  REQUIRE(across->face == FaceId{1, 0});
}

TEST_CASE("contains: solids hold points, flat shapes none") {
  const Transform up = Transform::translation({0, 0, 5});
  REQUIRE(contains({Sphere{}, up, {}, {}, 0}, {0, 0, 4.5}));
  REQUIRE_FALSE(contains({Sphere{}, up, {}, {}, 0}, {0, 0, 3.5}));
  REQUIRE_FALSE(contains({Square{}, up, {}, {}, 0}, {0, 0, 5}));
  REQUIRE(is_solid(Box{}));
  REQUIRE_FALSE(is_solid(Square{}));
}
