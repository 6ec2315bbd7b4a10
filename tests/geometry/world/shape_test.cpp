#include "geometry/world/shape.h"
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

TEST_CASE("next_crossing: where rounding leaves no exit, it is at once") {
  // Known to be inside, though the line runs past, or the exit lies behind.
  const auto past = next_crossing(Sphere{}, LocalRay{{1 + 1e-15, 0, 0}, {0, 0, 1}}, known(true));
  REQUIRE(past);
  REQUIRE(past->t == 0.0);
  REQUIRE_FALSE(past->entering);
  REQUIRE(next_crossing(Sphere{}, along_z(1.0 + 1e-15), known(true))->t == 0.0);
  const auto box = next_crossing(Box{}, LocalRay{{1 + 1e-15, 0, 0}, {0, 0, 1}}, known(true));
  REQUIRE(box);
  REQUIRE(box->t == 0.0);
  REQUIRE(box->face.face == 1);
  // Even a direction that contradicts its contact: straight out through the face it should leave.
  const auto wrong = next_crossing(Box{}, LocalRay{{1, 0, 0}, {1, 0, 0}}, touching(1, true));
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

TEST_CASE("next_crossing: a tree left by a rounding is left at once, through the right face") {
  // Just past the inner wall of a hollow ball; a brick hidden in the hollow lies nearer still.
  const double z = -0.5 + 0x1p-50;
  const CsgTree shell(CsgOperation::subtract, CsgTree(Sphere{}, Transform()),
                      CsgTree(Sphere{}, Transform::scaling(dvec3(0.5))));
  const CsgTree brick(
      Box{}, Transform::translation({0, 0, z + 0.25}).after(Transform::scaling({0.1, 0.1, 0.25})));
  for (const CsgTree& tree : {shell, CsgTree(CsgOperation::subtract, shell, brick)}) {
    const auto out = next_crossing(tree, along_z(z), known(true));
    REQUIRE(out);
    CHECK(out->t == 0.0);
    CHECK_FALSE(out->entering);
    CHECK(out->face == FaceId{1, 0});
  }
}

TEST_CASE("next_crossing: t_error holds for solids stretched a thousandfold, and far away") {
  using namespace reference;
  Random random(60);
  double worst = 0.0;
  int compared = 0;
  for (int k = 0; k < 3000; ++k) {
    glm::dmat3 stretch(1.0);
    stretch[random.below(3)] *= 1000.0;
    const Twin shape = k % 4 == 0   ? sphere()
                       : k % 4 == 1 ? box()
                       : k % 4 == 2 ? polyhedron(random.planes(9))
                                    : tapered_cylinder(random.uniform(0.0, 2.0));
    const Twin twin = placed(shape, random.rotation() * stretch * random.rotation(),
                             random.in_cube(k % 8 < 4 ? 1.0 : 1e5));
    const Transform& at = twin.placed.to_world;
    for (int i = 0; i < 30; ++i) {
      const dvec3 o = at.point(random.in_cube(random.chance(0.5) ? 1.2 : 0.01)) +
                      random.in_cube(random.chance(0.5) ? 1.0 : 1e4);
      const dvec3 d = glm::normalize(at.point(random.in_cube(1.2)) - o);
      const auto truth = twin.solid.crossings(Vec(o), Vec(d));
      if (truth.size() != 2 || truth[1].t - truth[0].t < 1e-6L || truth[1].t < 1e-6L) continue;
      const bool inside = truth[0].t < 0;
      const Real expected = inside ? truth[1].t : truth[0].t;
      const LocalRay ray = local_ray(at, {o, d});
      const auto found =
          std::visit([&](const auto& solid) { return next_crossing(solid, ray, known(inside)); },
                     twin.placed.shape);
      REQUIRE(found);
      const double off = double(std::abs(found->t - expected));
      worst = std::max(worst, off / found->t_error);
      ++compared;
    }
  }
  CHECK(compared > 30000);
  CHECK(worst < 1.0);
}

TEST_CASE("next_crossing: t_error holds along a plate a million times longer than thick") {
  using namespace reference;
  Random random(61);
  double worst = 0.0;
  for (int k = 0; k < 300; ++k) {
    glm::dmat3 thin(1.0);
    thin[0][0] = 1e-3;
    const Twin plate = polyhedron({{{1, 0, 0}, 1},
                                   {{-1, 0, 0}, 1},
                                   {{0, 1, 0}, 1},
                                   {{0, -1, 0}, 1},
                                   {{0, 0, 1}, 1000},
                                   {{0, 0, -1}, 1000}});
    const Twin twin = placed(plate, random.rotation() * thin, random.in_cube(0.1));
    const Transform& at = twin.placed.to_world;
    for (int i = 0; i < 30; ++i) {
      const dvec3 o = at.point(random.in_cube(0.5));
      const dvec3 to(random.chance(0.5) ? 1 : -1, 0, random.uniform(-1000, 1000));
      const dvec3 d = glm::normalize(at.point(to) - o);
      const auto truth = twin.solid.crossings(Vec(o), Vec(d));
      REQUIRE(truth.size() == 2);
      const auto found = next_crossing(std::get<ConvexPolyhedron>(twin.placed.shape),
                                       local_ray(at, {o, d}), known(true));
      REQUIRE(found);
      worst = std::max(worst, double(std::abs(found->t - truth[1].t)) / found->t_error);
    }
  }
  CHECK(worst < 1.0);
}

TEST_CASE("contains: solids hold points, flat shapes none") {
  const Transform up = Transform::translation({0, 0, 5});
  REQUIRE(contains({Sphere{}, up, {}, {}, 0}, {0, 0, 4.5}));
  REQUIRE_FALSE(contains({Sphere{}, up, {}, {}, 0}, {0, 0, 3.5}));
  REQUIRE_FALSE(contains({Square{}, up, {}, {}, 0}, {0, 0, 5}));
  REQUIRE(is_solid(Box{}));
  REQUIRE_FALSE(is_solid(Square{}));
}

TEST_CASE("shape: a ray that starts a little in front of a tree's edge goes into the tree") {
  // It has met the face x = -1 of the first block; by as much as the ray that led there was off, it
  // lies in front of the face y = -1 of the second one. It leaves where y = 1.
  const CsgTree both(CsgOperation::intersect, CsgTree(Box{}, Transform()),
                     CsgTree(Box{}, Transform()));
  for (const double off : {1e-14, 1e-12, 1e-9, 1e-6}) {
    const LocalRay ray{{-1.0, -1.0 - off, 0.0}, {0.6, 0.8, 0.0}};
    const auto next = next_crossing(both, ray, {true, true, {0, 0}, {}});
    REQUIRE(next);
    CHECK_FALSE(next->entering);
    CHECK(std::abs(next->t - (2.0 + off) / 0.8) < 1e-12);
    CHECK(next->face.face == 3);
  }
}

TEST_CASE("shape: a ray that starts a little behind a tree's edge does not come back") {
  // It leaves by the face x = 1 of the first block, above the second one's face y = 1; its numbers
  // are a little below.
  const CsgTree both(
      CsgOperation::unite,
      CsgTree(Box{},
              Transform::translation({0.0, 0.5, 0.0}).after(Transform::scaling({1, 1.5, 1}))),
      CsgTree(Box{}, Transform::translation({0.5, 0.0, 0.0})));
  const LocalRay ray{{1.0, 1.0 - 1e-9, 0.0}, {0.6, 0.8, 0.0}};
  CHECK_FALSE(next_crossing(both, ray, {false, true, {0, 1}, {}}));
}

TEST_CASE("shape: a ray along a ball's surface leaves by that, not by a face far away") {
  // The second ball is missed, since the origin is off by more than the depth of the chord.
  const CsgTree ball(Sphere{}, Transform());
  const CsgTree lens(CsgOperation::intersect, CsgTree(CsgOperation::intersect, ball, ball),
                     CsgTree(Box{}, Transform::scaling(dvec3(1.5))));
  const LocalRay ray{{1.0 + 1e-12, 0.0, 0.0}, {-1e-8, 1.0, 0.0}};
  const auto next = next_crossing(lens, ray, {true, true, {0, 0}, {}});
  REQUIRE(next);
  CHECK_FALSE(next->entering);
  CHECK(next->t < 1e-6);
  CHECK(next->face.leaf != 2);
}
