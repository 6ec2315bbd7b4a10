#include "geometry/mesh.h"
#include "geometry/world.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <numbers>
#include <optional>
#include <stdexcept>

using namespace abbe;
using reference::Random;
using reference::Real;
using reference::Vec;

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

/// A ring of `around` x `about` quads, each two triangles: concave, with a hole.
Mesh torus(int around, int about) {
  std::vector<dvec3> vertices;
  std::vector<Triangle> triangles;
  const auto number = [&](int i, int k) { return (i % around) * about + k % about; };
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < about; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * k / about;
      const double r = 1.0 + 0.5 * std::cos(v);
      vertices.emplace_back(r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v));
      const std::int32_t a = number(i, k), b = number(i + 1, k), c = number(i + 1, k + 1),
                         d = number(i, k + 1);
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  return {vertices, triangles};
}

/// The triangles of a mesh in the world, in 80-bit arithmetic.
struct Soup {
  std::vector<std::array<Vec, 3>> triangles;

  Soup(const Mesh& mesh, const glm::dmat3& linear, const dvec3& offset) {
    for (int i = 0; i < static_cast<int>(mesh.triangles().size()); ++i) {
      std::array<Vec, 3> corners{};
      for (int c = 0; c < 3; ++c)
        corners[static_cast<std::size_t>(c)] =
            reference::Mat(linear) * Vec(mesh.corner(i, c)) + Vec(offset);
      triangles.push_back(corners);
    }
  }

  /// The first crossing ahead by Cramer's rule, and how close it or a near miss is to an edge.
  struct First {
    Real t = INFINITY, cosine = 1, edge = INFINITY;
    int triangle = -1;
  };
  [[nodiscard]] First first(const Vec& o, const Vec& d) const {
    First found;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [a, b, c] = triangles[i];
      const Vec n = glm::cross(b - a, c - a);
      const Real speed = glm::dot(n, d);
      const Real t = glm::dot(n, a - o) / speed;
      const Vec p = o + t * d;
      const Real u = glm::dot(n, glm::cross(b - p, c - p)) / glm::dot(n, n);
      const Real v = glm::dot(n, glm::cross(c - p, a - p)) / glm::dot(n, n);
      const Real least = std::min({u, v, 1 - u - v});
      if (t > 0) found.edge = std::min(found.edge, std::abs(least));
      if (least < 0 || t <= 0 || t >= found.t) continue;
      found.t = t;
      found.cosine = std::abs(speed) / glm::length(n);
      found.triangle = static_cast<int>(i);
    }
    return found;
  }
  /// The winding number about a point: 1 inside, 0 outside; empty close to the surface.
  [[nodiscard]] std::optional<bool> contains(const Vec& p) const {
    Real angle = 0;
    for (const auto& t : triangles) {
      const Vec a = t[0] - p, b = t[1] - p, c = t[2] - p;
      const Real la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      const Real volume = glm::dot(a, glm::cross(b, c));
      const Vec n = glm::cross(b - a, c - a);
      if (std::abs(volume) < 1e-9L * glm::length(n) && la + lb + lc < 6) return std::nullopt;
      angle += 2 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                          glm::dot(c, a) * lb);
    }
    return std::abs(angle) > 2 * std::numbers::pi_v<Real>;
  }
};

RayState ray(const dvec3& origin, const dvec3& towards) {
  RayState state;
  state.ray = {origin, glm::normalize(towards - origin)};
  return state;
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
        state = {{hit->point, glm::normalize(d)},
                 back ? hit->same_side : hit->other_side,
                 back ? hit->nesting_before : hit->nesting_after};
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
    const auto out =
        mesh.closest({{a->point, state.ray.direction}, a->other_side, a->nesting_after});
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

TEST_CASE("mesh: what is no surface is refused") {
  CHECK_THROWS_AS(Mesh({}, {}), std::invalid_argument);
  CHECK_THROWS_AS(Mesh(cube_corners(), {{0, 1, 8}}), std::invalid_argument);
  CHECK_THROWS_AS(Mesh(cube_corners(), {{0, 1, -1}}), std::invalid_argument);
  CHECK_THROWS_AS(Mesh(cube_corners(), {{0, 1, 1}}), std::invalid_argument);
}
