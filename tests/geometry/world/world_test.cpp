#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/scene.h"

#include <functional>
#include <numbers>

using namespace abbe;
using namespace abbe::reference;

namespace {

/// 100 random maps of one shape, 1000 random rays each, from up to `far` away and from inside.
Tally compare(std::uint64_t seed, const std::function<Twin(Random&)>& make, double far = 10.0) {
  Random random(seed);
  Tally tally;
  for (int k = 0; k < 100; ++k) {
    Scene scene;
    scene.add(placed(make(random), random.linear(), random.in_cube(5.0)));
    const World world(scene.shapes(), far + 20.0);
    const Transform& at = scene.twins[0].placed.to_world;
    for (int i = 0; i < 1000; ++i) {
      const bool near = i % 4 == 0; // about the shape, often inside
      const dvec3 o = at.point(random.in_cube(near ? 1.0 : 2.0)) +
                      (near ? dvec3(0.0) : random.direction() * random.uniform(0.0, far));
      const dvec3 d = at.point(random.in_cube(1.5)) - o;
      const RayState state = free_ray(scene, o, d);
      const auto hit = world.closest(state);
      tally.add(judge(scene, state.ray, hit, 1e-13 * (20.0 + far)), hit.has_value());
    }
  }
  return tally;
}

void check(const Tally& tally) {
  CHECK(tally.differ == 0);
  CHECK(tally.undecided <= 5);
  CHECK(tally.hits > 20000);
}

RayState ray(const dvec3& origin, const dvec3& direction) {
  RayState state;
  state.ray = {origin, direction};
  return state;
}

World one(const Shape& shape, double farthest_coordinate = 10.0) {
  return World({{shape, {}, {1}, {}, 0}}, farthest_coordinate);
}

} // namespace

TEST_CASE("world: spheres under affine maps") {
  check(compare(20, [](Random&) { return sphere(); }));
}

TEST_CASE("world: boxes under affine maps") {
  check(compare(21, [](Random&) { return box(); }));
}

TEST_CASE("world: the prism under affine maps") {
  check(compare(22, [](Random&) { return prism(); }));
}

TEST_CASE("world: convex polyhedra under affine maps") {
  check(compare(23, [](Random& random) { return polyhedron(random.planes(12)); }));
}

TEST_CASE("world: squares under affine maps") {
  check(compare(24, [](Random&) { return square(); }));
}

TEST_CASE("world: discs under affine maps") {
  check(compare(40, [](Random&) { return disc(); }));
}

TEST_CASE("world: planes under affine maps") {
  check(compare(41, [](Random&) { return plane(); }));
}

TEST_CASE("world: cylinders, cones and what is between under affine maps") {
  check(compare(42, [](Random&) { return tapered_cylinder(1.0); }));
  check(compare(43, [](Random&) { return tapered_cylinder(0.0); }));
  check(compare(44, [](Random& random) { return tapered_cylinder(random.uniform(0.0, 2.0)); }));
}

TEST_CASE("world: trees of cylinders and cones under affine maps") {
  check(compare(45, [](Random& random) {
    const auto leaf = [&](double top) {
      return piece(placed(tapered_cylinder(top), random.linear(), random.in_cube(0.5)));
    };
    const Piece both = combined(CsgOperation::unite, leaf(0.0), leaf(1.0));
    return csg(combined(CsgOperation::subtract, both, leaf(0.5)));
  }));
}

TEST_CASE("world: lenses under affine maps") {
  check(compare(25, [](Random&) { return csg(lens_piece(0.5)); }));
}

TEST_CASE("world: nested trees under affine maps") {
  check(compare(26, [](Random& random) { return csg(nested_piece(random)); }));
}

TEST_CASE("world: far away origins") {
  for (const double far : {1e4, 1e6}) {
    const Tally tally = compare(
        27,
        [](Random& random) {
          return random.chance(0.3)   ? sphere()
                 : random.chance(0.5) ? csg(lens_piece(0.3))
                                      : tapered_cylinder(random.uniform(0.0, 2.0));
        },
        far);
    CHECK(tally.differ == 0);
    CHECK(tally.undecided < 50);
    CHECK(tally.hits > 20000);
  }
}

TEST_CASE("world: of many shapes the nearest is met") {
  Random random(28);
  Tally tally;
  for (int k = 0; k < 100; ++k) {
    Scene scene;
    for (int i = 0; i < 40; ++i) {
      Twin twin = i % 6 == 0   ? sphere()
                  : i % 6 == 1 ? box()
                  : i % 6 == 2 ? prism()
                  : i % 6 == 3 ? square()
                  : i % 6 == 4 ? csg(lens_piece(0.5))
                               : polyhedron(random.planes(8));
      scene.add(placed(twin, random.linear(), random.in_cube(8.0)));
    }
    const World world(scene.shapes(), 20.0);
    for (int i = 0; i < 1000; ++i) {
      const RayState state = free_ray(scene, random.in_cube(9.0), random.direction());
      const auto hit = world.closest(state);
      tally.add(judge(scene, state.ray, hit, 3e-12), hit.has_value());
    }
  }
  CHECK(tally.differ == 0);
  CHECK(tally.undecided <= 5);
  CHECK(tally.hits > 20000);
}

TEST_CASE("world: edges and corners of the box are met from outside") {
  const World world = one(Box{});
  const auto corner = world.closest(ray({-3, -3, -3}, glm::normalize(dvec3(1, 1, 1))));
  REQUIRE(corner);
  CHECK(corner->t == Approx(2 * std::numbers::sqrt3));
  CHECK(glm::length(corner->point - dvec3(-1, -1, -1)) < 1e-15);
  const auto edge = world.closest(ray({-3, -3, 0.5}, glm::normalize(dvec3(1, 1, 0))));
  REQUIRE(edge);
  CHECK(glm::length(edge->point - dvec3(-1, -1, 0.5)) < 1e-15);
  CHECK_FALSE(world.closest(ray({-3, -3, 1.0 + 1e-14}, glm::normalize(dvec3(1, 1, 0)))));
}

TEST_CASE("world: a ray in the plane of a face either misses or touches, and never stays inside") {
  const World world = one(Box{});
  for (const double height : {1.0 - 1e-15, 1.0, 1.0 + 1e-15}) {
    RayState state = ray({-3, 0, height}, {1, 0, 0});
    const auto in = world.closest(state);
    CHECK(in.has_value() == (height <= 1.0));
    if (!in) continue;
    CHECK(in->t == 2.0);
    state = in->going_on({1, 0, 0}, true);
    const auto out = world.closest(state);
    REQUIRE(out);
    CHECK_FALSE(out->entering);
    CHECK(out->t == 2.0);
    CHECK(out->nesting_after().empty());
    state = out->going_on({1, 0, 0}, true);
    CHECK_FALSE(world.closest(state));
  }
}

TEST_CASE("world: the prism's apex edge and base corners") {
  const World world = one(thesis_prism());
  const auto apex = world.closest(ray({0, 0, -5}, {0, 0, 1}));
  REQUIRE(apex);
  CHECK(apex->t == Approx(3.0));
  const double s = std::numbers::sqrt3;
  const auto base = world.closest(ray({s - 1e-9, -5, 1 - 1e-12}, {0, 1, 0}));
  REQUIRE(base);
  CHECK(base->t == Approx(4.0));
  CHECK_FALSE(world.closest(ray({s + 1e-9, -5, 1 - 1e-12}, {0, 1, 0})));
}

TEST_CASE("world: a tangent to a sphere passes or touches, and goes on") {
  const World world = one(Sphere{});
  CHECK_FALSE(world.closest(ray({1 + 1e-15, 0, -3}, {0, 0, 1})));
  const auto touch = world.closest(ray({1, 0, -3}, {0, 0, 1}));
  REQUIRE(touch);
  CHECK(touch->t == 3.0);
  RayState state = touch->going_on({0, 0, 1}, true);
  const auto out = world.closest(state);
  REQUIRE(out);
  CHECK(out->t == 0.0);
  state = out->going_on({0, 0, 1}, true);
  CHECK(state.nesting.empty());
  CHECK_FALSE(world.closest(state));
}

TEST_CASE("world: a ray in a concave edge meets one wall, then the other, and comes back") {
  const Transform upright =
      Transform::translation({-1, 0, 0})
          .after(Transform::rotation(90, {0, 1, 0}).after(Transform::scaling({3, 1, 1})));
  const std::vector<PlacedShape> squares{{Square{}, {}, {1}, {}, 0},
                                         {Square{}, upright, {2}, {}, 0}};
  const Transform floor = Transform::translation({0, 0, -1}).after(Transform::scaling({4, 4, 1}));
  const std::vector<PlacedShape> boxes{{Box{}, floor, {1}, {}, 0},
                                       {Box{}, Transform::translation({-2, 0, 0}), {2}, {}, 0}};
  Random random(31);
  for (const auto& walls : {squares, boxes}) {
    const World world(walls, 10.0);
    for (int i = 0; i < 1000; ++i) {
      // Towards (-1, y, 0), where the wall x = -1 stands on the floor z = 0.
      const dvec3 o(random.uniform(-0.9, 0.5), 0, random.uniform(0.1, 0.9));
      RayState state = ray(o, glm::normalize(dvec3(-1, random.uniform(-0.9, 0.9), 0) - o));
      const dvec3 back(-state.ray.direction.x, state.ray.direction.y, -state.ray.direction.z);
      int bounces = 0;
      while (const auto hit = world.closest(state)) {
        REQUIRE(++bounces <= 2);
        if (bounces == 2) REQUIRE(hit->t < 1e-14);
        const dvec3 d = state.ray.direction;
        state.ray = {hit->point, d - 2.0 * glm::dot(d, hit->normal) * hit->normal};
        hit->go_on(false, state.contacts, state.nesting);
      }
      REQUIRE(bounces == 2);
      REQUIRE(glm::length(state.ray.direction - back) < 1e-15);
    }
  }
}

TEST_CASE("world: turning back behind a hidden boundary, a ray is still inside what it passed") {
  // A low-priority box inside a ball of higher priority does not show; the ball's far wall does.
  Scene scene;
  scene.add(placed(sphere(), glm::dmat3(2.0), {0, 0, 0}), 1, 1);
  scene.add(placed(box(), glm::dmat3(1.0), {0, 0, 1.5}), 2, 0); // from z = 0.5 to 2.5
  const World world(scene.shapes(), 10.0);
  const auto hit = world.closest(free_ray(scene, {0, 0, 0}, {0, 0, 1}));
  REQUIRE(hit);
  CHECK(hit->t == 2.0);
  CHECK(hit->shape.value == 0);
  CHECK(hit->medium_before.value == 1);
  CHECK(hit->medium_after.value == 2);
  REQUIRE(hit->nesting_before.size() == 2);
  REQUIRE(hit->nesting_after().size() == 1);
  CHECK(hit->nesting_after()[0].value == 1);
  // Through the ball again: the box is left unseen, and the ray comes out into the open.
  const RayState back = hit->going_on({0, 0, -1}, false);
  const auto out = world.closest(back);
  REQUIRE(out);
  CHECK(out->t == 4.0);
  CHECK(out->nesting_after().empty());
}

TEST_CASE("world: a world scaled by a power of two gives the same hits, scaled") {
  Random random(29);
  std::vector<PlacedShape> shapes;
  for (int i = 0; i < 24; ++i) {
    const Twin twin = i % 6 == 0   ? sphere()
                      : i % 6 == 1 ? box()
                      : i % 6 == 2 ? csg(nested_piece(random))
                      : i % 6 == 3 ? tapered_cylinder(random.uniform(0.0, 2.0))
                      : i % 6 == 4 ? disc()
                                   : polyhedron(random.planes(8));
    shapes.push_back(placed(twin, random.linear() * 1.5, random.in_cube(6.0)).placed);
    if (i % 6 != 4) shapes.back().medium = {i % 3};
  }
  for (const int power : {-10, 10, -33, 33}) {
    const double scale = std::ldexp(1.0, power);
    std::vector<PlacedShape> scaled = shapes;
    for (PlacedShape& s : scaled)
      s.to_world = Transform::scaling(dvec3(scale)).after(s.to_world);
    const World unit(shapes, 20.0), other(scaled, 20.0 * scale);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
      RayState state = ray(random.in_cube(10.0), random.direction());
      state.nesting = unit.nesting_at(state.ray.origin);
      for (int bounce = 0; bounce < 4; ++bounce) {
        RayState there = state;
        there.ray.origin *= scale;
        const auto a = unit.closest(state), b = other.closest(there);
        REQUIRE(a.has_value() == b.has_value());
        if (!a) break;
        ++hits;
        REQUIRE(b->t == a->t * scale);
        REQUIRE(b->normal == a->normal);
        REQUIRE(b->point == a->point * scale);
        REQUIRE(b->face == a->face);
        REQUIRE(b->shape == a->shape);
        state = a->going_on(state.ray.direction, true);
      }
    }
    REQUIRE(hits > 1000);
  }
}

TEST_CASE("world: nesting_at and medium_of") {
  Scene scene;
  const glm::dmat3 unit(1.0);
  scene.add(placed(box(), unit * 3.0, {0, 0, 0}), 10);
  scene.add(placed(sphere(), unit * 2.0, {0, 0, 0}), 11, 2);
  scene.add(placed(sphere(), unit, {0, 0, 2}), 12, 1);
  scene.add(placed(square(), unit, {0, 0, 0}));
  scene.add(placed(box(), unit * 0.1, {0, 0, -1}));
  const World world(scene.shapes(), 10.0);
  const auto medium = [&](const dvec3& p) { return world.medium_of(world.nesting_at(p)).value; };
  CHECK(medium({0, 0, 4}) == -1);
  CHECK(medium({0, 0, 2.5}) == 12); // beats the box around it
  CHECK(medium({0, 0, 1.5}) == 11); // beats both
  CHECK(medium({2.5, 2.5, 0}) == 10);
  CHECK(world.nesting_at({0, 0, 1.5}).size() == 3);
  CHECK(world.nesting_at({0, 0, -1}).size() == 3); // an opaque solid is listed too
  Random random(30);
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p = random.in_cube(4.0);
    const Nesting ours = world.nesting_at(p), truth = scene.nesting(Vec(p));
    REQUIRE(std::equal(ours.begin(), ours.end(), truth.begin(), truth.end()));
  }
}

TEST_CASE("world: empty, and with solids that are nowhere") {
  CHECK_FALSE(World({}, 1.0).closest(ray({0, 0, 0}, {0, 0, 1})));
  CHECK_FALSE(World({}, 0.0).occluded(ray({0, 0, 0}, {0, 0, 1}), 5.0));
  const CsgTree nothing(CsgOperation::intersect, CsgTree(Sphere{}, Transform()),
                        CsgTree(Sphere{}, Transform::translation({0, 5, 0})));
  CHECK_FALSE(one(nothing).closest(ray({0, 0, -3}, {0, 0, 1})));
  CHECK_FALSE(embree_version().empty());
}

TEST_CASE("world: a plane is met to the horizon, and from there the solids on it") {
  const World world(
      {{Plane{}, {}, {1}, {}, 0}, {Sphere{}, Transform::translation({0, 0, 1}), {2}, {}, 0}}, 5.0);
  for (const double way : {1e3, 1e6, 1e9, 1e12}) {
    const auto hit = world.closest(ray({2, 2, 1}, glm::normalize(dvec3(way, 0, -1))));
    REQUIRE(hit);
    CHECK(hit->shape.value == 0);
    CHECK(hit->point.x == Approx(way + 2.0));
    CHECK(hit->point.z == 0.0);
    // Back from out there to where the ball is widest, just inside its rim and just outside.
    const auto back = [&](double y) {
      RayState state = ray(hit->point + dvec3(0, -2, 0), {});
      state.ray.direction = glm::normalize(dvec3(0, y, 1) - state.ray.origin);
      state.contacts = hit->going_on(state.ray.direction, false).contacts;
      return world.closest(state);
    };
    const double blur = 1e-15 * way + 1e-6;
    const auto ball = back(1.0 - blur);
    REQUIRE(ball);
    CHECK(ball->shape.value == 1);
    CHECK_FALSE(back(1.0 + 1.0 / way + blur));
  }
}

TEST_CASE("world: a plane under a scene of solids changes no hit above it") {
  Random random(33);
  Scene solids, all;
  for (int i = 0; i < 40; ++i) {
    const Twin twin =
        placed(i % 2 ? tapered_cylinder(0.5) : sphere(), random.linear(), random.in_cube(8.0));
    solids.add(twin);
    all.add(twin);
  }
  all.add(placed(plane(), random.rotation(), {0, 0, 0}));
  const World without(solids.shapes(), 20.0), with(all.shapes(), 20.0);
  int nearer = 0;
  for (int i = 0; i < 20000; ++i) {
    const RayState state = free_ray(solids, random.in_cube(9.0), random.direction());
    const auto a = without.closest(state), b = with.closest(state);
    if (b && b->shape.value == 40) {
      ++nearer;
      CHECK((!a || a->t >= b->t));
      continue;
    }
    REQUIRE(a.has_value() == b.has_value());
    if (a) CHECK((a->t == b->t && a->shape == b->shape));
  }
  CHECK(nearer > 2000);
}

TEST_CASE("a ray that has come from or gone to where no float reaches meets what its line meets") {
  Scene scene;
  scene.add(sphere());
  scene.add(placed(plane(), glm::dmat3(1.0), {0, 0, -2}));
  const World world(scene.shapes(), 10.0);
  for (const double far : {1e17, 1e19, 1e30, 1e39}) {
    INFO(far);
    RayState state;
    state.ray = {{0, 0, far}, {0, 0, 1}};
    CHECK_FALSE(world.closest(state)); // it runs away
    state.ray = {{far, 0, far}, {0, 0, -1}};
    const auto ground = world.closest(state);
    REQUIRE(ground);
    CHECK(ground->shape.value == 1);
    CHECK(ground->t == Approx(far));
    std::vector<RayState> states(16, state);
    std::vector<Hit> hits(16);
    world.find_closest(states, hits, Tracing::packets);
    CHECK(hits[3].met());
  }
}
