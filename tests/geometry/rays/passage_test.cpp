#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/mesh_reference.h"
#include "tests/geometry/random.h"

#include <optional>
#include <vector>

// Rays that are followed straight on through the corners and edges of solids, or end there. They
// need not meet a corner in any particular way, but every walk must end, and end on the right side.

using namespace abbe;
using namespace abbe::reference;

namespace {

/// A cube of twelve triangles.
Mesh cube() {
  return {{{-1, -1, -1},
           {1, -1, -1},
           {-1, 1, -1},
           {1, 1, -1},
           {-1, -1, 1},
           {1, -1, 1},
           {-1, 1, 1},
           {1, 1, 1}},
          {{0, 2, 3},
           {0, 3, 1},
           {4, 5, 7},
           {4, 7, 6},
           {0, 1, 5},
           {0, 5, 4},
           {2, 6, 7},
           {2, 7, 3},
           {0, 4, 6},
           {0, 6, 2},
           {1, 3, 7},
           {1, 7, 5}}};
}

CsgTree brick(const dvec3& centre) {
  return {Box{}, Transform::translation(centre).after(Transform::scaling(dvec3(0.5)))};
}

/// Eight cubes at the corners of a cube, of which every other one is there: edges and corners
/// touch.
CsgTree chequered() {
  std::optional<CsgTree> all;
  for (int i = 0; i < 8; ++i) {
    if ((i & 1) ^ (i >> 1 & 1) ^ (i >> 2 & 1)) continue;
    const dvec3 centre(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    all = all ? CsgTree(CsgOperation::unite, *all, brick(centre)) : brick(centre);
  }
  return *all;
}

struct Walked {
  int boundaries = 0;
  bool ended = false, inside = false;
};

/// Follows a ray straight on, as shadow rays are.
Walked walk(const World& world, RayState state, double distance) {
  Walked walked;
  Passage passage;
  Hit hit;
  while (walked.boundaries < 1000) {
    world.find_closest(state, distance, passage, hit);
    if (!hit.met()) {
      walked.ended = true;
      break;
    }
    ++walked.boundaries;
    if (!passage.go_through(hit, state)) break;
    distance -= hit.t;
  }
  walked.inside = !state.nesting.empty();
  return walked;
}

} // namespace

// A light on a corner, the middle of an edge, or a face: rays from each place of the surroundings
// end there. Before it, the ray has crossed nothing if it comes from outside and does not run
// through the cube; what rounding cannot tell from the end does not count.
TEST_CASE("a ray that ends on a corner, an edge or a face of a mesh ends") {
  Random random(120);
  for (const double scale : {1.0, 1e-4, 1e4})
    for (const double away : {0.0, 7.3}) {
      const Transform at = Transform::translation(dvec3(away * scale, 0.0, -away * scale))
                               .after(Transform::rotation(away * 10.0, {1, 2, 3}))
                               .after(Transform::scaling(dvec3(scale)));
      const World world({{cube(), at, {0}, {0}, 0}}, 100.0 * scale);
      for (int i = 0; i < 27; ++i) {
        const dvec3 lamp(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        for (int k = 0; k < 200; ++k) {
          const dvec3 place = random.in_cube(4.0);
          const dvec3 from = at.point(place), to = at.point(lamp);
          RayState state{{from, glm::normalize(to - from)}, {}, world.nesting_at(from)};
          const Walked walked = walk(world, state, glm::distance(from, to));
          REQUIRE(walked.ended);
          REQUIRE(walked.boundaries <= 3);
          const bool started_inside = !state.nesting.empty();
          const bool sees = [&] { // the light's face, if the line is not about in its plane
            for (int axis = 0; axis < 3; ++axis)
              if (std::abs(lamp[axis]) == 1.0 && lamp[axis] * place[axis] > 1.001) return true;
            return false;
          }();
          if (!started_inside && sees && i != 13) REQUIRE(walked.boundaries == 0);
        }
      }
    }
}

TEST_CASE("rays straight through the corners and edges of solids come out again") {
  Random random(121);
  const std::vector<PlacedShape> kinds = {{cube(), {}, {0}, {0}, 0},
                                          {icosphere(1), {}, {0}, {0}, 0},
                                          {chequered(), {}, {0}, {0}, 0},
                                          {Box{}, {}, {0}, {0}, 0}};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    for (const double scale : {1.0, 1e-4})
      for (const double away : {0.0, 1e3}) {
        CAPTURE(kind, scale, away);
        const Transform at =
            Transform::translation(dvec3(away * scale)).after(Transform::scaling(dvec3(scale)));
        PlacedShape placed = kinds[kind];
        placed.to_world = at;
        const World world({placed}, (10.0 + away) * scale);
        for (int k = 0; k < 5000; ++k) {
          dvec3 target;
          if (const auto* mesh = std::get_if<Mesh>(&placed.shape)) {
            const auto [a, b, c] =
                mesh->corners(random.below(static_cast<int>(mesh->triangles().size())));
            target = random.chance(0.5) ? a : 0.5 * (a + b);
          } else {
            target = {random.below(3) - 1, random.below(3) - 1, random.below(3) - 1};
          }
          const dvec3 from =
              at.point(random.chance(0.5) ? random.in_cube(4.0)
                                          : dvec3(random.below(9) - 4, random.below(9) - 4, 4));
          const dvec3 to = at.point(target);
          const RayState state{{from, glm::normalize(to - from)}, {}, world.nesting_at(from)};
          const Walked walked = walk(world, state, kInfinity);
          REQUIRE(walked.ended);
          REQUIRE_FALSE(walked.inside);
          REQUIRE(walked.boundaries < 40);
        }
      }
}
