#include "geometry/meshes/mesh.h"
#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/mesh_reference.h"
#include "tests/geometry/random.h"

#include <numbers>
#include <stdexcept>

using namespace abbe;
using namespace abbe::reference;

namespace {

std::vector<Triangle> cube_triangles() {
  return {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
}

std::vector<dvec3> cube_corners() {
  std::vector<dvec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return corners;
}

Mesh cube() {
  return {cube_corners(), cube_triangles()};
}

RayState ray(const dvec3& origin, const dvec3& towards) {
  RayState state;
  state.ray = {origin, glm::normalize(towards - origin)};
  return state;
}

/// From a point to a triangle. The least distance on the line parallel to one edge is a convex
/// function of the line's place, whose least value is closed in upon; no case of vertex, edge,
/// face.
Real distance(const std::array<Vec, 3>& t, const Vec& p) {
  const auto on_line = [&](Real u) {
    const Vec from = t[0] + u * (t[1] - t[0]) - p, way = (1 - u) * (t[2] - t[0]);
    const Real v = std::clamp(-glm::dot(from, way) / glm::dot(way, way), Real(0), Real(1));
    return glm::length(from + v * way);
  };
  Real low = 0, high = 1 - 1e-15L;
  for (int i = 0; i < 150; ++i) {
    const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (on_line(a) < on_line(b))
      high = b;
    else
      low = a;
  }
  return on_line(low);
}

World one(const Mesh& mesh, MediumId medium = {0}) {
  return World({{mesh, {}, {0}, medium, 0}}, 20.0);
}

} // namespace

TEST_CASE("mesh: 1e5 rays against brute force, under affine maps with mirrors") {
  Random random(110);
  const Mesh ring = torus(24, 12);
  int hits = 0, differ = 0, undecided = 0;
  for (int k = 0; k < 50; ++k) {
    const glm::dmat3 linear = random.linear();
    const dvec3 offset = random.in_cube(5.0);
    const Transform at(linear, offset);
    const Soup soup(ring, linear, offset);
    const World world({{ring, at, {0}, {0}, 0}}, 30.0);
    for (int i = 0; i < 2000; ++i) {
      const dvec3 to = at.point(random.in_cube(1.3));
      RayState state = ray(at.point(random.in_cube(random.chance(0.5) ? 1.0 : 6.0)), to);
      state.nesting = world.nesting_at(state.ray.origin);
      const auto hit = world.closest(state);
      const auto truth = soup.first(Vec(state.ray.origin), Vec(state.ray.direction));
      hits += hit.has_value();
      const bool same = hit ? std::abs(hit->t - truth.t) < 1e-12L / truth.cosine &&
                                  hit->entering == state.nesting.empty()
                            : truth.triangle < 0;
      if (same) continue;
      ++(truth.edge < 1e-10L ? undecided : differ);
    }
  }
  CHECK(differ == 0);
  CHECK(undecided < 20);
  CHECK(hits > 50000);
}

TEST_CASE("mesh: walks find no leak, at any scale and place") {
  const Mesh ring = torus(16, 8);
  int segments = 0, wrong = 0, stuck = 0, checked = 0;
  for (const auto& [scale, far] : {std::pair(1.0, 0.0), {1e-4, 0.0}, {1e4, 0.0}, {1.0, 1e5}}) {
    Random random(111);
    const Transform at(random.linear() * scale, random.direction() * (far + scale));
    const World world({{ring, at, {0}, {0}, 0}}, far + 20.0 * scale);
    const Soup local(ring, glm::dmat3(1.0), dvec3(0.0));
    for (int k = 0; k < 5000; ++k) {
      RayState state = ray(at.point(random.in_cube(3.0)), at.point(random.in_cube(1.2)));
      // Often exactly at a vertex, or at the middle of an edge.
      if (random.chance(0.3)) {
        const int t = random.below(static_cast<int>(ring.triangles().size()));
        const dvec3 mark =
            random.chance(0.5) ? ring.corner(t, 0) : 0.5 * (ring.corner(t, 0) + ring.corner(t, 2));
        state.ray.direction = glm::normalize(at.point(mark) - state.ray.origin);
      }
      state.nesting = world.nesting_at(state.ray.origin);
      for (int step = 0; step < 30; ++step) {
        const auto hit = world.closest(state);
        ++segments;
        if (!hit && !state.nesting.empty()) ++stuck;
        if (k % 10 == 0) {
          const double length = hit ? hit->t : 10.0 * scale;
          const auto in = local.contains(Vec(at.inverse_point(state.ray.at(0.4142 * length))));
          checked += in.has_value();
          if (in && length > 1e-6 * scale && *in == state.nesting.empty()) ++wrong;
        }
        if (!hit) break;
        const bool back = random.chance(0.4);
        dvec3 d = state.ray.direction;
        if (back) d -= 2.0 * glm::dot(d, hit->normal) * hit->normal;
        const dvec3 bent = glm::normalize(d + random.in_cube(random.chance(0.5) ? 0.1 : 1.0));
        if (glm::dot(bent, hit->normal) * glm::dot(d, hit->normal) > 0.0) d = bent;
        state = hit->going_on(glm::normalize(d), !back);
      }
    }
  }
  CHECK(segments > 40000);
  CHECK(checked > 3000);
  CHECK(stuck == 0);
  CHECK(wrong == 0);
}

TEST_CASE("mesh: a cube of triangles answers as the cube, on edges and diagonals too") {
  const World mesh = one(cube()), box({{Box{}, {}, {0}, {0}, 0}}, 20.0);
  Random random(112);
  for (int i = 0; i < 20000; ++i) {
    dvec3 to = random.in_cube(1.2);
    for (int axis = 0; axis < 3; ++axis)
      if (random.chance(0.2)) to[axis] = 0.0; // the diagonals, and symmetric lines
    const RayState state = ray(random.in_cube(1.0) + dvec3(0, 0, 4), to);
    const auto a = mesh.closest(state), b = box.closest(state);
    REQUIRE(a.has_value() == b.has_value());
    if (!a) continue;
    CHECK(std::abs(a->t - b->t) < 1e-14);
    CHECK(glm::length(a->normal - b->normal) < 1e-14);
    const auto out = mesh.closest(a->going_on(state.ray.direction, true));
    REQUIRE(out);
    CHECK_FALSE(out->entering);
  }
  const auto corner = mesh.closest(ray({-3, -3, -3}, {0, 0, 0}));
  REQUIRE(corner);
  CHECK(corner->t == Approx(2 * std::numbers::sqrt3));
  CHECK_FALSE(mesh.closest(ray({-3, -3, 1 + 1e-15}, {3, 3, 1 + 1e-15})));
}

TEST_CASE("mesh: a cube of triangles cemented to a cube leaves no air between them") {
  const World world(
      {{cube(), {}, {0}, {0}, 0}, {Box{}, Transform::translation({0, 0, 2}), {1}, {1}, 0}}, 20.0);
  Random random(113);
  for (int i = 0; i < 5000; ++i) {
    const dvec3 shared(random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), 1.0);
    RayState state = ray(random.in_cube(0.9), shared);
    state.nesting = world.nesting_at(state.ray.origin);
    const auto hit = world.closest(state);
    REQUIRE(hit);
    REQUIRE(hit->medium_before.value == 0);
    REQUIRE(hit->medium_after.value == 1);
  }
}

TEST_CASE("mesh: vertices at one place are one, inside out is turned, an open one has no inside") {
  std::vector<dvec3> corners;
  std::vector<Triangle> apart, inside_out, open = cube_triangles();
  for (const Triangle& t : cube_triangles()) {
    const auto n = static_cast<std::int32_t>(corners.size());
    for (const std::int32_t i : t)
      corners.push_back(cube_corners()[static_cast<std::size_t>(i)]);
    apart.push_back({n, n + 1, n + 2});
    inside_out.push_back({t[0], t[2], t[1]});
  }
  apart.push_back({0, 0, 1}); // no area
  const Mesh merged(corners, apart), turned(cube_corners(), inside_out);
  CHECK(merged.vertices().size() == 8);
  CHECK(merged.triangles().size() == 12);
  for (const Mesh& mesh : {merged, turned, cube()}) {
    CHECK(mesh.is_closed());
    CHECK(is_solid(mesh));
    CHECK(contains({mesh, {}, {}, {}, 0}, {0.9, 0.9, -0.9}));
    CHECK_FALSE(contains({mesh, {}, {}, {}, 0}, {0.9, 0.9, -1.1}));
  }
  open.pop_back();
  const Mesh hollow(cube_corners(), open);
  CHECK_FALSE(hollow.is_closed());
  CHECK_FALSE(is_solid(hollow));
  CHECK_FALSE(contains({hollow, {}, {}, {}, 0}, {0, 0, 0}));
  const auto inner = one(hollow, {}).closest(ray({0, 0, 0}, {-1, 0.1, 0.2}));
  REQUIRE(inner); // seen from inside too
  CHECK_FALSE(inner->entering);
}

TEST_CASE("mesh: copies share, an equal mesh of its own answers the same") {
  const Mesh ring = torus(24, 12), other = torus(24, 12);
  const Transform left = Transform::translation({-2, 0, 0});
  const Transform right =
      Transform::translation({2, 0, 0}).after(Transform::rotation(90, {1, 0, 0}));
  const World shared({{ring, left, {0}, {0}, 0}, {ring, right, {1}, {1}, 0}}, 20.0);
  const World apart({{ring, left, {0}, {0}, 0}, {other, right, {1}, {1}, 0}}, 20.0);
  const auto mesh = [](const World& world, std::size_t i) {
    return std::get<Mesh>(world.shapes()[i].shape).triangles().data();
  };
  CHECK(mesh(shared, 0) == ring.triangles().data());
  CHECK(mesh(shared, 1) == ring.triangles().data());
  CHECK(mesh(apart, 1) == other.triangles().data());
  CHECK(mesh(apart, 1) != mesh(apart, 0));
  Random random(114);
  int second = 0;
  for (int i = 0; i < 20000; ++i) {
    const RayState state = ray(random.in_cube(1.0) + dvec3(0, 0, 5), random.in_cube(3.0));
    const auto a = shared.closest(state), b = apart.closest(state);
    REQUIRE(a.has_value() == b.has_value());
    if (!a) continue;
    second += a->shape.value;
    CHECK((a->t == b->t && a->shape == b->shape && a->face == b->face && a->normal == b->normal));
  }
  CHECK(second > 1000);
}

TEST_CASE("mesh: areas and corners") {
  CHECK(cube().area() == Approx(24.0));
  const double triangle =
      std::sqrt(3.0) / 4 * std::pow(4.0 / std::sqrt(10.0 + 2 * std::sqrt(5.0)), 2);
  CHECK(icosphere(0).area() == Approx(20 * triangle)); // edges 4 / sqrt(10 + 2 sqrt 5) long
  const Mesh ring = torus(24, 12);
  double sum = 0.0;
  for (int i = 0; i < static_cast<int>(ring.triangles().size()); ++i) {
    const auto [a, b, c] = ring.corners(i);
    CHECK(b == ring.corner(i, 1));
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  CHECK(ring.area() == Approx(sum));
}

TEST_CASE("mesh: the face by which a ray goes where it is moved least is what brute force finds") {
  const Mesh ring = torus(40, 20);
  const Soup soup(ring, glm::dmat3(1.0), dvec3(0.0));
  Random random(115);
  int against = 0;
  for (int i = 0; i < 600; ++i) {
    const LocalRay ray{random.in_cube(random.chance(0.5) ? 1.5 : 10.0), random.direction()};
    const bool entering = random.chance(0.5);
    // To the triangle, and where the ray runs against it, by as much as it comes below it.
    const auto move = [&](const std::array<Vec, 3>& t) {
      const Vec o(ray.origin), n = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
      const Real speed = glm::dot(n, Vec(ray.direction));
      const Real reach =
          std::max({glm::length(t[0] - o), glm::length(t[1] - o), glm::length(t[2] - o)});
      return distance(t, o) + ((speed < 0) == entering ? 0 : reach * std::abs(speed));
    };
    Real least = INFINITY;
    for (const auto& t : soup.triangles)
      if (glm::length(t[0] - Vec(ray.origin)) - 0.5L < least) // no edge is longer
        least = std::min(least, move(t));
    const auto [face, at] = nearest_face(ring, ray, entering);
    CHECK(std::abs(at - least) < 1e-12L);
    CHECK(std::abs(move(soup.triangles[static_cast<std::size_t>(face)]) - least) < 1e-12L);
    against += (glm::dot(outward_normal(ring, {}, face), ray.direction) < 0.0) != entering;
  }
  CHECK(against > 5); // both happen
  CHECK(against < 595);
}

TEST_CASE("mesh: a triangle that is seen from its edge is met where it is, or not at all") {
  // Lines in the plane of a triangle, within rounding, where the signs of its edges are rounding.
  const Mesh ball = icosphere(1);
  Random random(118);
  int met = 0;
  Real worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const int face = random.below(static_cast<int>(ball.triangles().size()));
    const auto [a, b, c] = ball.corners(face);
    const dvec3 in_plane =
        a + random.uniform(-3.0, 3.0) * (b - a) + random.uniform(-3.0, 3.0) * (c - a);
    const dvec3 d =
        glm::normalize(random.uniform(-1.0, 1.0) * (b - a) + random.uniform(-1.0, 1.0) * (c - a));
    const LocalRay ray{in_plane - 5.0 * d, d};
    const MeshCrossings found = first_crossings(ball, ray, {}, MeshSearch::either);
    for (const Root& root : {found.enter, found.exit}) {
      if (root.t == kInfinity) continue;
      const auto corners = ball.corners(root.face.face);
      const std::array<Vec, 3> triangle{Vec(corners[0]), Vec(corners[1]), Vec(corners[2])};
      worst = std::max(worst, distance(triangle, Vec(ray.at(root.t))));
      met += root.face.face == face;
    }
  }
  CHECK(met > 20); // some of them
  CHECK(worst < 1e-14L);
}

TEST_CASE("mesh: bounds hold all vertices and are not much wider") {
  Random random(116);
  for (const Mesh& mesh : {cube(), torus(24, 12), icosphere(4)})
    for (int map = 0; map < 20; ++map) {
      const Transform at(random.linear(), random.in_cube(5.0));
      const Bounds box = bounds(mesh, at);
      Bounds truth;
      for (const dvec3& v : mesh.vertices())
        truth = truth.joined({at.point(v), at.point(v)});
      const dvec3 size = truth.upper - truth.lower;
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(box.lower[axis] <= truth.lower[axis]);
        CHECK(box.upper[axis] >= truth.upper[axis]);
        CHECK(box.upper[axis] - box.lower[axis] < 1.25 * size[axis]);
      }
    }
}

TEST_CASE("mesh: what is no surface is refused") {
  CHECK_THROWS_AS(Mesh({}, {}), std::invalid_argument);
  CHECK_THROWS_AS(Mesh(cube_corners(), {{0, 1, 8}}), std::invalid_argument);
  CHECK_THROWS_AS(Mesh(cube_corners(), {{0, 1, -1}}), std::invalid_argument);
  CHECK_THROWS_AS(Mesh(cube_corners(), {{0, 1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(Mesh({{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}, {{0, 1, 2}}), std::invalid_argument);
}

TEST_CASE("mesh: what lies between the boxes of its triangles is inside too") {
  Random random(117);
  const Mesh ball = icosphere(1);
  int checked = 0, wrong = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<dvec3> vertices = ball.vertices();
    for (dvec3& v : vertices)
      v *= random.uniform(0.4, 1.0);
    const Mesh jagged(vertices, ball.triangles());
    const Soup soup(jagged, glm::dmat3(1.0), dvec3(0.0));
    for (int k = 0; k < 50; ++k) {
      const dvec3 p = random.in_cube(0.7);
      const auto in = soup.contains(Vec(p));
      checked += in.has_value();
      wrong += in && *in != (signed_distance(jagged, p) < 0.0);
    }
  }
  CHECK(checked > 9000);
  CHECK(wrong == 0);
}
