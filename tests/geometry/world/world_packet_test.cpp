#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/scene.h"

using namespace abbe;
using namespace abbe::reference;

namespace {

bool same(const Contacts& a, const Contacts& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.shape == y.shape && x.face == y.face && x.side == y.side;
  });
}

bool same(const Nesting& a, const Nesting& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// Whether rays that go on from both know the same.
bool same(const RayState& a, const RayState& b) {
  return same(a.contacts, b.contacts) && same(a.nesting, b.nesting);
}

bool same(const Hit& a, const Hit& b) {
  return a.t == b.t && a.point == b.point && a.normal == b.normal && a.shape == b.shape &&
         a.face == b.face && a.entering == b.entering && a.material == b.material &&
         a.medium_before == b.medium_before && a.medium_after == b.medium_after &&
         same(a.going_on({}, false), b.going_on({}, false)) &&
         same(a.going_on({}, true), b.going_on({}, true));
}

Scene clutter(Random& random) {
  Scene scene;
  for (int i = 0; i < 30; ++i) {
    const Twin twin = i % 7 == 0   ? sphere()
                      : i % 7 == 1 ? box()
                      : i % 7 == 2 ? csg(lens_piece(0.4))
                      : i % 7 == 3 ? square()
                      : i % 7 == 4 ? tapered_cylinder(random.uniform(0.0, 2.0))
                      : i % 7 == 5 ? disc()
                                   : prism();
    scene.add(placed(twin, random.linear(), random.in_cube(5.0)), i % 4 - 1, i % 3);
  }
  scene.add(placed(plane(), random.rotation(), random.in_cube(5.0)));
  return scene;
}

} // namespace

TEST_CASE("packets and single rays give the same bits") {
  Random random(40);
  int hits = 0, rays = 0;
  for (int k = 0; k < 10; ++k) {
    const World world(clutter(random).shapes(), 10.0);
    for (std::size_t count = 1; count <= 40; ++count)
      for (const double spread : {0.0, 1e-3, 0.3, 10.0}) { // coherent to incoherent
        std::vector<RayState> states(count);
        const dvec3 o = random.in_cube(8.0), d = random.direction();
        for (RayState& state : states) {
          state.ray = {o + random.in_cube(spread), glm::normalize(d + random.in_cube(spread))};
          state.nesting = world.nesting_at(state.ray.origin);
        }
        for (int bounce = 0; bounce < 3; ++bounce) {
          std::vector<Hit> single(count), packet(count);
          world.find_closest(states, single, Tracing::single);
          world.find_closest(states, packet, Tracing::packets);
          for (std::size_t i = 0; i < count; ++i) {
            ++rays;
            REQUIRE(single[i].met() == packet[i].met());
            if (!single[i].met()) continue;
            ++hits;
            REQUIRE(same(single[i], packet[i]));
            states[i] = single[i].going_on(states[i].ray.direction, true);
          }
        }
      }
  }
  CHECK(hits > rays / 10);
}

TEST_CASE("a component of a direction next to zero loses no other ray of a packet") {
  Random random(42);
  const World world(clutter(random).shapes(), 10.0);
  int hits = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<RayState> states(16);
    for (RayState& state : states) {
      dvec3 d = random.direction();
      if (random.chance(0.2))
        d[random.below(3)] = (random.chance(0.5) ? 1.0 : -1.0) *
                             std::pow(10.0, random.uniform(random.chance(0.5) ? -40 : -20, -16));
      state.ray = {random.in_cube(8.0), glm::normalize(d)};
      state.nesting = world.nesting_at(state.ray.origin);
    }
    std::vector<Hit> single(16), packet(16);
    world.find_closest(states, single, Tracing::single);
    world.find_closest(states, packet, Tracing::packets);
    for (std::size_t i = 0; i < 16; ++i) {
      REQUIRE(single[i].met() == packet[i].met());
      hits += single[i].met();
      if (single[i].met()) REQUIRE(same(single[i], packet[i]));
    }
  }
  CHECK(hits > 16000);
}

TEST_CASE("the order of shapes changes nothing but their numbers") {
  Random random(41);
  std::vector<PlacedShape> shapes = clutter(random).shapes(), reversed = shapes;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    shapes[i].priority = static_cast<int>(i); // so that ties do not go by number
    reversed[shapes.size() - 1 - i] = shapes[i];
  }
  const World a(shapes, 10.0), b(reversed, 10.0);
  for (int i = 0; i < 20000; ++i) {
    RayState state;
    state.ray = {random.in_cube(8.0), random.direction()};
    const auto there = b.nesting_at(state.ray.origin);
    RayState other = state;
    state.nesting = a.nesting_at(state.ray.origin);
    other.nesting = there;
    const auto x = a.closest(state), y = b.closest(other);
    REQUIRE(x.has_value() == y.has_value());
    if (!x) continue;
    REQUIRE(x->t == y->t);
    REQUIRE(x->normal == y->normal);
    REQUIRE(x->material == y->material);
    REQUIRE(x->medium_after == y->medium_after);
  }
}
