#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

using namespace abbe;

namespace {

constexpr ShapeId kLamp{0}, kOther{1};

Mesh cube_mesh() {
  std::vector<dvec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
  return Mesh(corners, {{0, 2, 1},
                        {1, 2, 3},
                        {4, 5, 6},
                        {5, 7, 6},
                        {0, 1, 4},
                        {1, 5, 4},
                        {2, 6, 3},
                        {3, 6, 7},
                        {0, 4, 2},
                        {2, 4, 6},
                        {1, 3, 5},
                        {3, 7, 5}});
}

/// Solids that reach down to z = -1 and end at z = 1 in a face that holds |x|, |y| < 0.7.
std::vector<Shape> solids() {
  const auto half_space = [](double x, double y, double z) { return HalfSpace{{x, y, z}, 1.0}; };
  CsgTree bitten(CsgOperation::subtract, CsgTree(Box{}, Transform()),
                 CsgTree(Sphere{}, Transform::translation({0.0, 0.0, -2.0})));
  return {Box{},
          ConvexPolyhedron({half_space(1, 0, 0), half_space(-1, 0, 0), half_space(0, 1, 0),
                            half_space(0, -1, 0), half_space(0, 0, 1), half_space(0, 0, -1)}),
          cube_mesh(), bitten};
}

std::vector<Transform> places() {
  const Transform turned = Transform::rotation(25.0, {1.0, 2.0, 3.0});
  std::vector<Transform> all;
  for (const double scale : {1e-4, 1.0, 3.7})
    for (const dvec3& offset : {dvec3(0.0), dvec3{1000.0, 700.0, -300.0}})
      all.push_back(Transform::translation(scale < 1.0 ? scale * offset : offset)
                        .after(Transform::scaling(dvec3(scale)).after(turned)));
  return all;
}

/// A square a third as wide on top of a solid: the normal points out of it.
Transform on_top() {
  return Transform::translation({0.1, 0.2, 1.0}).after(Transform::scaling({0.3, 0.3, 1.0}));
}

} // namespace

TEST_CASE("rays that begin on a face of a solid begin outside or inside, as their direction says") {
  reference::Random random(3);
  for (const Transform& place : places())
    for (const Shape& solid : solids()) {
      PlacedShape lamp{Square{}, place.after(on_top()), MaterialId{0}, {}, 0};
      PlacedShape glass{solid, place, MaterialId{1}, MediumId{0}, 0};
      const double size = glm::length(place.vector({0.0, 0.0, 1.0}));
      const World world({lamp, glass}, 1e3 * size);
      for (int i = 0; i < 400; ++i) {
        const dvec3 point =
            lamp.to_world.point({random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0});
        const dvec3 d{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                      random.uniform(0.01, 1.0)};
        const dvec3 up = glm::normalize(place.vector(d));
        const auto out = world.start_on({kLamp, {}, Side::outside}, {point, up});
        REQUIRE(out);
        CHECK(out->nesting.empty());
        CHECK(out->contacts.size() == 2);
        CHECK_FALSE(world.closest(*out));
        const auto in = world.start_on({kLamp, {}, Side::inside}, {point, -up});
        REQUIRE(in);
        REQUIRE(in->nesting.size() == 1);
        CHECK(in->nesting[0] == kOther);
        const auto hit = world.closest(*in);
        REQUIRE(hit);
        CHECK(hit->shape == kOther);
        CHECK_FALSE(hit->entering);
        CHECK(hit->t > 1e-3 * size);
        CHECK(world.start_at({point, up}).nesting.empty());
        CHECK(world.start_at({point, -up}).nesting.size() == 1);
      }
      CHECK_FALSE(world.stands_alone(kLamp));
      CHECK(world.hiders(kLamp).empty()); // what is flat shows before glass
    }
}

TEST_CASE("a surface that another one covers shows nowhere there") {
  for (const Transform& place : places()) {
    const Transform half = place.after(Transform::translation({1.0, 0.0, 0.0}));
    PlacedShape lamp{Square{}, place, MaterialId{0}, {}, 0};
    PlacedShape card{Square{}, half, MaterialId{1}, {}, 0};
    const double size = glm::length(place.vector({0.0, 0.0, 1.0}));
    const dvec3 up = glm::normalize(place.vector({0.3, 0.1, 1.0}));
    for (const bool covered : {true, false}) {
      card.priority = covered ? 0 : -1;
      const World world({lamp, card}, 1e3 * size);
      CHECK(world.hiders(kLamp).empty() == !covered);
      for (int i = 1; i < 40; ++i) {
        const dvec3 local{i / 20.0 - 1.0, 0.3, 0.0};
        if (i == 20) continue; // the card's edge
        const bool shows = local.x < 0.0 || !covered;
        const dvec3 point = place.point(local);
        CHECK(world.start_on({kLamp, {}, Side::outside}, {point, up}).has_value() == shows);
        CHECK(world.start_on({kLamp, {}, Side::inside}, {point, -up}).has_value() == shows);
        CHECK(world.shows(kLamp, world.hiders(kLamp), {point + 3.0 * size * up, -up}, 3.0 * size) ==
              shows);
      }
    }
  }
}

TEST_CASE("an equal solid that was defined later hides the first, a smaller one does not") {
  for (const Transform& place : places())
    for (const Shape& solid : {Shape(Box{}), Shape(Sphere{}), Shape(cube_mesh())}) {
      const double size = glm::length(place.vector({0.0, 0.0, 1.0}));
      const dvec3 down = -glm::normalize(place.vector({0.01, 0.02, 1.0}));
      const dvec3 point = place.point({0.0, 0.0, 1.0});
      const Ray ray{point - 3.0 * size * down, down};
      for (const double scale : {1.0, 0.5}) {
        const Transform inner = place.after(Transform::scaling(dvec3(scale)));
        const World world(
            {{solid, place, MaterialId{0}, {}, 0}, {solid, inner, MaterialId{1}, {}, 0}},
            1e3 * size);
        const bool equal = scale == 1.0;
        CHECK_FALSE(world.hiders(kLamp).empty());
        CHECK(world.shows(kLamp, world.hiders(kLamp), ray, 3.0 * size) == !equal);
        CHECK(world.shows(kOther, world.hiders(kOther),
                          {inner.point({0.0, 0.0, 1.0}) - 3.0 * size * down, down}, 3.0 * size));
      }
    }
}

TEST_CASE("a place on a ball is inside for rays that go in, outside for those that go out") {
  reference::Random random(5);
  for (const Transform& place : places()) {
    const World world({{Sphere{}, place, MaterialId{0}, MediumId{0}, 0}},
                      1e3 * glm::length(place.vector({0.0, 0.0, 1.0})));
    for (int i = 0; i < 500; ++i) {
      const dvec3 local = random.direction(), other = random.direction();
      if (std::abs(glm::dot(local, other)) < 1e-3) continue;
      const Ray ray{place.point(local), glm::normalize(place.vector(other))};
      const RayState state = world.start_at(ray);
      CHECK(state.nesting.empty() == (glm::dot(local, other) > 0.0));
      CHECK(state.contacts.size() == 1);
    }
    CHECK(world.stands_alone({0}));
  }
}

TEST_CASE("shapes beside each other stand alone, those in each other or on a plane do not") {
  const auto at = [](const Shape& shape, const dvec3& place) {
    return PlacedShape{shape, Transform::translation(place), MaterialId{0}, {}, 0};
  };
  const World world({at(Sphere{}, {0.0, 0.0, 5.0}), at(Box{}, {4.0, 0.0, 3.0}),
                     at(Sphere{}, {4.0, 0.0, 3.2}), at(Plane{}, {0.0, 0.0, 0.0}),
                     at(Square{}, {9.0, 9.0, 0.0})},
                    20.0);
  CHECK(world.stands_alone({0}));
  CHECK_FALSE(world.stands_alone({1}));
  CHECK_FALSE(world.stands_alone({2}));
  CHECK_FALSE(world.stands_alone({4}));
  CHECK(world.hiders({0}).empty());
  CHECK_FALSE(world.hiders({3}).empty());
  CHECK(world.hiders({4}).empty());
}

TEST_CASE("rays that are not finite meet nothing, and do not disturb those beside them") {
  const World world({{Sphere{}, Transform(), MaterialId{0}, {}, 0}}, 10.0);
  std::vector<RayState> rays(16);
  const double bad[] = {kInfinity, -kInfinity, std::nan("")};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    rays[i].ray = {{0.01 * static_cast<double>(i), 0.0, 5.0}, {0.0, 0.0, -1.0}};
    if (i % 2 == 1) continue;
    dvec3& part = i % 4 == 0 ? rays[i].ray.origin : rays[i].ray.direction;
    part[static_cast<int>(i % 3)] = bad[i % 5 % 3];
  }
  for (const std::size_t count : {1, 3, 7, 16}) {
    std::vector<Hit> hits(count);
    world.find_closest(std::span(rays).first(count), hits, Tracing::packets);
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(hits[i].met() == (i % 2 == 1));
      CHECK(world.closest(rays[i]).has_value() == (i % 2 == 1));
      CHECK(world.occluded(rays[i], 9.0));
      CHECK(world.occluded(rays[i], 2.0) == (i % 2 == 0));
    }
  }
}

TEST_CASE("a start inside a small tree, close to its face, is inside at any scale") {
  for (const double scale : {1.0, 1e-4, 1e-9}) {
    const CsgTree tree(CsgOperation::intersect, CsgTree(Box{}, Transform()),
                       CsgTree(Box{}, Transform::translation({0.0, 0.0, -0.5})));
    const World world({{tree, Transform::scaling(dvec3(scale)), {}, {0}, 0}}, 10.0 * scale);
    // A ten-millionth of its size below the face z = 1/2; rounding is a billionth of that.
    const RayState out = world.start_at({{0.0, 0.0, (0.5 - 1e-7) * scale}, {0.0, 0.0, 1.0}});
    CAPTURE(scale);
    CHECK(out.contacts.empty());
    CHECK(out.nesting.size() == 1);
    const auto hit = world.closest(out);
    REQUIRE(hit);
    CHECK(hit->t == Approx(1e-7 * scale).epsilon(1e-6));
  }
}
