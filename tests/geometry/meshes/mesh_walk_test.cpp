#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/mesh_reference.h"
#include "tests/geometry/random.h"

#include <algorithm>
#include <string>

// Rays that are shut up in a mesh, mostly: they are reflected many times, and aim at vertices and
// edges. What they are said to be in is compared with winding numbers of points on their way.

using namespace abbe;
using namespace abbe::reference;

namespace {

struct Setting {
  std::string name;
  double scale = 1.0, away = 0.0; ///< of the mesh in the world
  double off_centre = 0.0;        ///< of the vertices in the mesh's own frame
};

const std::vector<Setting> kSettings = {{"unit", 1, 0, 0},
                                        {"small", 1e-4, 0, 0},
                                        {"large", 1e4, 0, 0},
                                        {"far", 1, 1e5, 0},
                                        {"far in its own frame", 1, 0, 1e4}};

struct Count {
  int segments = 0, checked = 0, leaks = 0, wrong = 0, behind = 0;
};

class Walker {
public:
  Walker(const Mesh& mesh, const Setting& setting, std::uint64_t seed)
      : random_(seed), scale_(setting.scale), mesh_(moved(mesh, random_.direction(), setting)),
        at_(linear(setting.scale), random_.direction() * setting.away),
        soup_(mesh_, glm::dmat3(1.0), dvec3(0.0)), middle_(mesh_.hierarchy().centre),
        world_({{mesh_, at_, {0}, {0}, 0}}, setting.away + setting.scale * setting.off_centre) {}

  Count run(int segments) {
    while (count_.segments < segments)
      walk();
    return count_;
  }

private:
  static Mesh moved(const Mesh& mesh, const dvec3& direction, const Setting& setting) {
    std::vector<dvec3> vertices = mesh.vertices();
    for (dvec3& v : vertices)
      v += setting.off_centre * direction;
    return {vertices, mesh.triangles()};
  }
  glm::dmat3 linear(double scale) { return random_.linear() * scale; } // half of them mirrored

  /// Often a vertex, or a point of an edge.
  dvec3 target() {
    if (random_.chance(0.6)) return at_.point(middle_ + random_.in_cube(1.3));
    const auto [a, b, c] = mesh_.corners(random_.below(static_cast<int>(mesh_.triangles().size())));
    return at_.point(random_.chance(0.5) ? a : a + random_.uniform(0.0, 1.0) * (b - a));
  }

  void walk() {
    RayState state;
    state.ray.origin = at_.point(middle_ + random_.in_cube(1.3));
    state.ray.direction = glm::normalize(target() - state.ray.origin);
    state.nesting = world_.nesting_at(state.ray.origin);
    for (int step = 0; step < 100; ++step) {
      const auto hit = world_.closest(state);
      ++count_.segments;
      if (!hit && !state.nesting.empty()) ++count_.leaks;
      if (hit && hit->t < 0.0) ++count_.behind;
      if (step % 7 == 0) check(state, hit ? hit->t : 10.0 * scale_);
      if (!hit) return;
      state = next(state, *hit);
    }
  }

  void check(const RayState& state, double length) {
    if (length < 1e-6 * scale_) return;
    for (const double part : {0.0717, 0.4142, 0.9137}) {
      const auto in = soup_.contains(Vec(at_.inverse_point(state.ray.at(part * length))));
      count_.checked += in.has_value();
      if (in && *in == state.nesting.empty()) ++count_.wrong;
    }
  }

  /// Reflected to the inside as a rule; a ray outside goes in.
  RayState next(const RayState& state, const Hit& hit) {
    const bool back = !hit.entering && random_.chance(0.95);
    dvec3 d = state.ray.direction;
    if (back) d -= 2.0 * glm::dot(d, hit.normal) * hit.normal;
    dvec3 other = random_.chance(0.5) ? target() - hit.point
                                      : d + random_.in_cube(random_.chance(0.5) ? 0.01 : 1.0);
    other = other == dvec3(0.0) ? d : glm::normalize(other); // the target may be where it is
    if (glm::dot(other, hit.normal) * glm::dot(d, hit.normal) > 0.0) d = other;
    return hit.going_on(glm::normalize(d), !back);
  }

  Random random_;
  double scale_;
  Mesh mesh_;
  Transform at_;
  Soup soup_;
  dvec3 middle_;
  World world_;
  Count count_;
};

void check(const Mesh& mesh, int segments = 20000) {
  REQUIRE(mesh.is_closed());
  std::uint64_t seed = 300;
  for (const Setting& setting : kSettings)
    for (int map = 0; map < 4; ++map) {
      const Count count = Walker(mesh, setting, seed++).run(segments / 4);
      INFO(setting.name << ", map " << map << ", " << count.segments << " segments");
      CHECK(count.leaks == 0);
      CHECK(count.wrong == 0);
      CHECK(count.behind == 0);
      CHECK(count.checked > count.segments / 20);
    }
}

/// A jagged ball: each vertex of an icosphere at a random distance of 0.5 to 1.
Mesh jagged(int levels) {
  Random random(310);
  const Mesh ball = icosphere(levels);
  std::vector<dvec3> vertices = ball.vertices();
  for (dvec3& v : vertices)
    v *= random.uniform(0.5, 1.0);
  return {vertices, ball.triangles()};
}

} // namespace

TEST_CASE("mesh walk: an icosphere, smooth and jagged") {
  check(icosphere(2));
  check(jagged(2));
}

TEST_CASE("mesh walk: a tetrahedron") {
  check(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
}

TEST_CASE("mesh walk: tori of thin slivers") {
  check(torus(60, 3));            // long, narrow quads across
  check(torus(3, 60));            // and along
  check(torus(16, 8, 1.0, 1e-3)); // flat: each triangle nearly parallel to its opposite
  check(torus(16, 8, 1e-3, 1.0)); // a thin-walled tube
}

TEST_CASE("mesh walk: two parts that are one mesh, one within the other's hole") {
  const Mesh ring = torus(16, 8), ball = icosphere(1);
  std::vector<dvec3> vertices = ring.vertices();
  std::vector<Triangle> triangles = ring.triangles();
  const auto first = static_cast<std::int32_t>(vertices.size());
  for (const dvec3& v : ball.vertices())
    vertices.push_back(0.4 * v);
  for (const Triangle& t : ball.triangles())
    triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  check({vertices, triangles});
}
