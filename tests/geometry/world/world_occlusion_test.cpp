#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/scene.h"

using namespace abbe;
using namespace abbe::reference;

namespace {

MediumId medium_at(const World& world, const Scene& scene, const Vec& point) {
  return world.medium_of(scene.nesting(point));
}

/// The distance of the first visible boundary, from the crossings of all shapes: one where an
/// opaque shape is met, or where the media on the two sides differ. Boundaries nearer than
/// `skip` are those of the surface that the ray leaves.
Real first_visible(const World& world, const Scene& scene, const Ray& ray, Real skip) {
  const Vec o(ray.origin), d(ray.direction);
  std::vector<std::pair<Real, int>> met;
  for (std::size_t i = 0; i < scene.twins.size(); ++i)
    for (const Crossing& c : scene.twins[i].solid.crossings(o, d))
      if (c.t > skip) met.push_back({c.t, static_cast<int>(i)});
  std::sort(met.begin(), met.end());
  for (std::size_t i = 0; i < met.size(); ++i) {
    const auto [t, shape] = met[i];
    if (!scene.twins[static_cast<std::size_t>(shape)].placed.medium.valid()) return t;
    const Real before = i == 0 ? 0 : met[i - 1].first;
    const Real after = i + 1 < met.size() ? met[i + 1].first : t + 1;
    if (medium_at(world, scene, o + (before + t) / 2 * d) !=
        medium_at(world, scene, o + (t + after) / 2 * d))
      return t;
  }
  return INFINITY;
}

Scene mixed(Random& random) {
  Scene scene;
  for (int i = 0; i < 16; ++i) {
    const Twin twin = i % 5 == 0   ? sphere()
                      : i % 5 == 1 ? box()
                      : i % 5 == 2 ? csg(lens_piece(0.4))
                      : i % 5 == 3 ? (i % 2 ? square() : disc())
                                   : (i % 2 ? prism() : tapered_cylinder(random.uniform(0, 2)));
    // Two glasses that often overlap, opaque solids, squares.
    const int medium = i % 5 == 3 || i % 7 == 0 ? -1 : i % 2;
    scene.add(placed(twin, random.linear(), random.in_cube(4.0)), medium, i % 3);
  }
  return scene;
}

} // namespace

TEST_CASE("occluded agrees with the crossings of all shapes") {
  Random random(50);
  int blocked = 0, open = 0, wrong = 0, inside = 0;
  for (int k = 0; k < 20; ++k) {
    const Scene scene = mixed(random);
    const World world(scene.shapes(), 10.0);
    for (int i = 0; i < 1000; ++i) {
      RayState state = free_ray(scene, random.in_cube(6.0), random.direction());
      for (int bounce = 0; bounce < 3; ++bounce) {
        const Real skip = bounce == 0 ? 0 : 1e-11L;
        const Real first = first_visible(world, scene, state.ray, skip);
        inside += !state.nesting.empty();
        const double near = std::isinf(first) ? 10.0 : static_cast<double>(first);
        for (const double distance : {0.5 * near, near - 1e-7, near + 1e-7, 2.0 * near}) {
          if (near < 1e-4) continue; // grazing a curved surface: decided by rounding
          const bool expected = first < distance;
          wrong += world.occluded(state, distance) != expected;
          (expected ? blocked : open)++;
        }
        wrong += world.occluded(state, kInfinity) != !std::isinf(first);
        const auto hit = world.closest(state);
        REQUIRE(hit.has_value() == !std::isinf(first));
        if (!hit) break;
        // Go on from the surface, back or through, in a direction of one's own choice.
        const bool opaque =
            !scene.twins[hit->shape.index()].placed.medium.valid() && !hit->nesting_after().empty();
        const bool back = opaque || random.chance(0.5);
        dvec3 d = random.direction();
        if (std::abs(glm::dot(d, hit->normal)) < 1e-3) break; // the reference knows no contacts
        const double ahead = glm::dot(state.ray.direction, hit->normal);
        if ((glm::dot(d, hit->normal) * ahead < 0.0) != back) d = -d;
        state = hit->going_on(d, !back);
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(blocked > 10000);
  CHECK(open > 10000);
  CHECK(inside > 3000);
}

TEST_CASE("occluded: a light on a surface lights what is before it, not what is behind") {
  Random random(51);
  int wrong = 0;
  for (int k = 0; k < 100; ++k) {
    Scene scene;
    const int kind = k % 3;
    scene.add(placed(kind == 0   ? box()
                     : kind == 1 ? sphere()
                                 : square(),
                     random.linear(), random.in_cube(k % 2 ? 5.0 : 1e4)));
    const World world(scene.shapes(), 1e4);
    const Transform& at = scene.twins[0].placed.to_world;
    for (int i = 0; i < 300; ++i) {
      // A light on the face z = 1 (z = 0 for the square, anywhere on the ball).
      const double x = random.uniform(-0.9, 0.9), y = random.uniform(-0.9, 0.9);
      const dvec3 local = kind == 0   ? dvec3(x, y, 1)
                          : kind == 1 ? random.direction()
                                      : dvec3(x, y, 0);
      const dvec3 n = kind == 1 ? local : dvec3(0, 0, 1);
      const dvec3 lamp = at.point(local);
      const dvec3 outside = n + random.direction() * 0.9;
      RayState state = free_ray(scene, at.point(local + outside * 3.0), {0, 0, 1});
      state.ray.direction = glm::normalize(lamp - state.ray.origin);
      wrong += world.occluded(state, glm::length(lamp - state.ray.origin));
      // From the other side a solid blocks; a square, which has no thickness, does not.
      state = free_ray(scene, at.point(local - n * 5.0 + random.in_cube(0.05)), {0, 0, 1});
      state.ray.direction = glm::normalize(lamp - state.ray.origin);
      if (kind == 2) continue;
      wrong += !world.occluded(state, glm::length(lamp - state.ray.origin));
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("occluded: from a contact the surface itself does not hide the light") {
  const World world({{Box{}, {}, {1}, {}, 0}}, 10.0);
  RayState state;
  state.ray = {{0, 0, 1}, {0, 0, 1}};
  state.contacts.push_back({{0}, {0, 5}, Side::outside});
  CHECK_FALSE(world.occluded(state, 1e9));
  CHECK_FALSE(world.occluded(state, kInfinity));
  state.ray.direction = {0, 0.6, 0.8};
  CHECK_FALSE(world.occluded(state, 1e9));
}

TEST_CASE("occluded: boundaries that do not show hide no light") {
  // Two overlapping pieces of the same glass, and a lower priority inside a higher one.
  Scene scene;
  const glm::dmat3 unit(1.0);
  scene.add(placed(box(), unit, {0, 0, 0}), 5, 1);
  scene.add(placed(box(), unit, {0, 0, 1}), 5, 1);
  scene.add(placed(sphere(), unit * 0.25, {0, 0, -0.5}), 6, 0);
  const World world(scene.shapes(), 10.0);
  const RayState state = free_ray(scene, {0, 0, -0.9}, {0, 0, 1});
  CHECK_FALSE(world.occluded(state, 2.8));
  CHECK(world.occluded(state, 3.0));
}
