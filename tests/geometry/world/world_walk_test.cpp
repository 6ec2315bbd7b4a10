#include "geometry/world/world.h"
#include "tests/catch.h"
#include "tests/geometry/scene.h"

#include <functional>
#include <string>

// Rays walk through scenes of touching, overlapping and nested solids. At each hit they turn back
// or go through, straight or bent. No epsilon keeps them from the surface they leave; what they are
// said to be in is compared with the membership of points between the crossings.

using namespace abbe;
using namespace abbe::reference;

namespace {

struct Setting {
  double scale = 1.0, offset = 0.0;
};

struct Walk {
  std::string name;
  Scene scene; ///< in a frame of its own, within a few units of the origin
  /// True for points on a face that two glasses share, away from its rim.
  std::function<bool(const dvec3&)> cemented = [](const dvec3&) { return false; };
};

struct Count {
  int segments = 0, undecided = 0, cemented = 0;
  int wrong_nesting = 0, wrong_medium = 0, missed = 0, stuck = 0, same_face = 0, gap = 0;
};

bool same(const Nesting& ascending, Nesting other) {
  std::sort(other.begin(), other.end());
  return std::equal(ascending.begin(), ascending.end(), other.begin(), other.end());
}

class Walker {
public:
  Walker(const Walk& walk, const Setting& setting, std::uint64_t seed)
      : walk_(walk), random_(seed), scale_(setting.scale),
        frame_(random_.rotation() * setting.scale, setting.offset == 0.0
                                                       ? random_.in_cube(setting.scale)
                                                       : random_.direction() * setting.offset) {
    for (const Twin& twin : walk.scene.twins) {
      const dvec3 o = frame_.point({0, 0, 0});
      scene_.twins.push_back(placed(
          twin, {frame_.vector({1, 0, 0}), frame_.vector({0, 1, 0}), frame_.vector({0, 0, 1})}, o));
    }
    world_.emplace(scene_.shapes(), setting.offset + 10.0 * scale_);
  }

  Count run(int segments) {
    while (count_.segments < segments)
      walk_once();
    return count_;
  }

private:
  /// Within it the place of a surface is a matter of rounding.
  [[nodiscard]] Real blur(const Vec& p) const {
    return 2e-14L * (glm::length(p) + 5 * Real(scale_));
  }

  /// A point to aim at: often exactly in an edge's or corner's coordinates.
  dvec3 target() {
    dvec3 p = random_.in_cube(1.3);
    for (int axis = 0; axis < 3; ++axis)
      if (random_.chance(0.1)) p[axis] = random_.chance(0.5) ? 1.0 : -1.0;
    return frame_.point(p);
  }

  void walk_once() {
    const dvec3 o = frame_.point(random_.in_cube(random_.chance(0.3) ? 1.0 : 4.0));
    if (scene_.clearance(Vec(o)) < blur(Vec(o))) return;
    RayState state = free_ray(scene_, o, target() - o);
    for (int step = 0; step < 60; ++step) {
      const auto hit = world_->closest(state);
      ++count_.segments;
      check(state, hit);
      if (!hit) return;
      state = next(state, *hit);
    }
  }

  void check(const RayState& state, const std::optional<Hit>& hit) {
    if (!hit && !state.nesting.empty()) ++count_.stuck;
    if (hit && !state.contacts.empty()) {
      const SurfaceContact& left = state.contacts[0];
      const Twin& twin = scene_.twins[left.shape.index()];
      const bool ball =
          std::holds_alternative<Sphere>(twin.placed.shape) ||
          std::holds_alternative<CsgTree>(twin.placed.shape) ||
          (std::holds_alternative<TaperedCylinder>(twin.placed.shape) && left.face.face == 0);
      if (hit->shape == left.shape && hit->face == left.face && !ball) ++count_.same_face;
    }
    const Vec o(state.ray.origin), d(state.ray.direction);
    const Real end = hit ? Real(hit->t) : 20 * Real(scale_);
    const Real end_margin =
        hit ? 4 * blur(o + end * d) / std::abs(glm::dot(Vec(hit->normal), d)) : 0;
    const MediumId medium = world_->medium_of(state.nesting);
    std::vector<Real> stops{0};
    // A line through an edge, by less than rounding, may be taken to miss.
    for (const Twin& twin : scene_.twins)
      for (const Crossing& c : twin.solid.crossings(o, d, 200 * blur(o))) {
        const Real margin = 4 * blur(o + c.t * d) / std::abs(glm::dot(c.normal, d));
        if (c.t <= margin || c.t >= end - std::max(margin, end_margin)) continue;
        if (twin.solid.flat || !twin.placed.medium.valid()) ++count_.missed;
        stops.push_back(c.t);
      }
    stops.push_back(end);
    std::sort(stops.begin(), stops.end());
    for (std::size_t i = 1; i < stops.size(); ++i) {
      if (i > 1 && stops[i] - stops[i - 1] < 200 * blur(o)) continue; // faces that coincide
      // Not half-way: between parallel faces that is on other faces' planes too often.
      const Vec middle = o + (stops[i - 1] + 0.4142L * (stops[i] - stops[i - 1])) * d;
      if (scene_.clearance(middle) < blur(middle)) {
        ++count_.undecided;
        continue;
      }
      // What a ray is in just before a hit is reported by the hit: on the way it may have passed
      // boundaries that do not show, the last perhaps a rounding before the hit.
      const Nesting truth = scene_.nesting(middle);
      const bool last = i + 1 == stops.size();
      if (last && !same(truth, state.nesting) && !(hit && same(truth, hit->nesting_before)))
        ++count_.wrong_nesting;
      if (world_->medium_of(truth) != medium) ++count_.wrong_medium;
    }
    if (hit && hit->medium_before != medium) ++count_.wrong_medium;
    if (hit && walk_.cemented(frame_.inverse_point(hit->point))) {
      ++count_.cemented;
      if (!hit->medium_before.valid() || !hit->medium_after.valid()) ++count_.gap;
    }
  }

  RayState next(const RayState& state, const Hit& hit) {
    const bool opaque = !scene_.twins[hit.shape.index()].placed.medium.valid() &&
                        is_solid(scene_.twins[hit.shape.index()].placed.shape);
    const bool back = opaque || random_.chance(0.4);
    dvec3 d = state.ray.direction;
    if (back) d -= 2.0 * glm::dot(d, hit.normal) * hit.normal;
    if (random_.chance(0.5)) { // bent, or scattered, but to the same side
      const dvec3 bent = glm::normalize(d + random_.in_cube(random_.chance(0.5) ? 0.1 : 1.0));
      if (glm::dot(bent, hit.normal) * glm::dot(d, hit.normal) > 0.0) d = bent;
    }
    return hit.going_on(glm::normalize(d), !back);
  }

  const Walk& walk_;
  Random random_;
  double scale_;
  Transform frame_;
  Scene scene_;
  std::optional<World> world_;
  Count count_;
};

Twin at(const Twin& twin, double size, const dvec3& centre) {
  return placed(twin, glm::dmat3(size), centre);
}

Twin brick(const dvec3& lower, const dvec3& upper) {
  const dvec3 half = 0.5 * (upper - lower);
  return placed(box(), {{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}, 0.5 * (lower + upper));
}

Twin minus(const Twin& a, const Twin& b) {
  return csg(combined(CsgOperation::subtract, piece(a), piece(b)));
}

Walk lone(const std::string& name, const Twin& twin) {
  Walk walk{name, {}};
  walk.scene.add(twin, 1);
  return walk;
}

Walk two_boxes() {
  Walk walk{"two boxes that share a face", {}};
  walk.scene.add(brick({-1, -1, -0.7}, {1, 1, 0.1}), 1);
  walk.scene.add(brick({-1, -1, 0.1}, {1, 1, 1.2}), 2);
  walk.cemented = [](const dvec3& p) {
    return std::abs(p.z - 0.1) < 1e-7 && std::abs(p.x) < 0.99 && std::abs(p.y) < 0.99;
  };
  return walk;
}

Walk doublet() {
  // A biconvex lens and a meniscus that share a ball's surface, z < 0.6.
  const Twin shared = at(sphere(), 1.0, {0, 0, -0.4});
  Walk walk{"a cemented doublet", {}};
  const Piece crown =
      combined(CsgOperation::intersect, piece(shared), piece(at(sphere(), 1.0, {0, 0, 0.8})));
  const Piece shell =
      combined(CsgOperation::subtract, piece(at(sphere(), 1.5, {0, 0, -0.6})), piece(shared));
  walk.scene.add(csg(crown), 1);
  walk.scene.add(
      csg(combined(CsgOperation::intersect, shell, piece(brick({-0.6, -0.6, 0.2}, {0.6, 0.6, 2})))),
      2);
  walk.cemented = [](const dvec3& p) {
    return std::abs(glm::length(p - dvec3(0, 0, -0.4)) - 1.0) < 1e-7 && p.z > 0.3 &&
           std::abs(p.x) < 0.59 && std::abs(p.y) < 0.59;
  };
  return walk;
}

Walk filled_shell() {
  Walk walk{"a shell and the ball that fills it", {}};
  const Twin core = at(sphere(), 0.6, {0.1, 0, 0});
  walk.scene.add(minus(sphere(), core), 1);
  walk.scene.add(core, 2);
  walk.cemented = [](const dvec3& p) { return glm::length(p) < 0.9; };
  return walk;
}

Walk overlapping() {
  Walk walk{"overlapping solids with priorities", {}};
  walk.scene.add(at(sphere(), 1.0, {0, 0, 0.4}), 1, 1);
  walk.scene.add(box(), 2, 0);
  walk.scene.add(at(prism(), 0.7, {0.5, 0.5, 0}), 3, 2);
  walk.scene.add(at(box(), 0.5, {0.5, 0.5, 0.5}), 2, 0); // shares three faces with the first box
  walk.scene.add(at(sphere(), 0.3, {0, 0, 0}), 1, 1);    // a hidden one of equal medium
  return walk;
}

Walk squares() {
  Walk walk{"squares on and inside a box, and opaque solids in its corners", {}};
  walk.scene.add(box(), 1);
  walk.scene.add(at(square(), 0.8, {0, 0, 1})); // exactly on a face
  walk.scene.add(at(square(), 0.5, {0, 0, 0}));
  walk.scene.add(brick({-1, -1, -1}, {0, 1, -0.5}));     // opaque, flush with three faces
  walk.scene.add(brick({-1, -1, -0.5}, {-0.5, 1, 0.5})); // standing on it: a concave edge
  return walk;
}

Walk room() {
  Walk walk{"a corner of three opaque walls", {}};
  walk.scene.add(brick({-1, -1, -1.2}, {1, 1, -1}));
  walk.scene.add(brick({-1.2, -1, -1}, {-1, 1, 1}));
  walk.scene.add(brick({-1, -1.2, -1}, {1, -1, 1}));
  walk.scene.add(at(sphere(), 0.5, {-0.5, -0.5, -0.5}), 1); // touches all three
  return walk;
}

Walk tree() {
  Random random(70);
  return lone("a nested tree", csg(nested_piece(random)));
}

Walk cylinders() {
  Walk walk{"cylinders and cones that touch", {}};
  walk.scene.add(at(tapered_cylinder(1.0), 0.5, {0, 0, 0}), 1);
  walk.scene.add(at(tapered_cylinder(0.0), 0.5, {0, 0, 0.5}), 2);                // on its top
  walk.scene.add(placed(tapered_cylinder(2.0), glm::dmat3(-0.5), {0, 0, 0}), 3); // under it
  walk.scene.add(at(disc(), 0.5, {0, 0, 0.25})); // across the first, to its side
  walk.cemented = [](const dvec3& p) {
    return std::abs(std::abs(p.z - 0.25) - 0.25) < 1e-7 && std::hypot(p.x, p.y) < 0.49;
  };
  return walk;
}

Walk ground() {
  Walk walk{"solids on an endless plane", {}};
  walk.scene.add(plane());
  walk.scene.add(at(tapered_cylinder(0.5), 1.0, {0, 0, 0}), 1);
  walk.scene.add(at(sphere(), 0.5, {1, 1, 0.5}), 1); // touches it
  return walk;
}

void check(const Walk& walk, int segments = 100000) {
  std::uint64_t seed = 80;
  for (const Setting& setting : {Setting{1, 0}, {1e-4, 0}, {1e4, 0}, {1, 1e5}, {1e-2, 1e5}}) {
    const int wanted = seed == 80 ? segments : segments / 4;
    const Count count = Walker(walk, setting, seed++).run(wanted);
    INFO(walk.name << ", scale " << setting.scale << ", offset " << setting.offset);
    INFO(count.undecided << " undecided of " << count.segments);
    CHECK(count.wrong_nesting == 0);
    CHECK(count.wrong_medium == 0);
    CHECK(count.missed == 0);
    CHECK(count.stuck == 0);
    CHECK(count.same_face == 0);
    CHECK(count.gap == 0);
    CHECK(count.undecided < count.segments / 50);
    if (walk.cemented({0.05, 0.05, 0.1})) CHECK(count.cemented > 100);
  }
}

} // namespace

TEST_CASE("walk: a sphere") {
  check(lone("a sphere", sphere()));
}
TEST_CASE("walk: a box") {
  check(lone("a box", box()));
}
TEST_CASE("walk: the prism") {
  check(lone("the prism", prism()));
}
TEST_CASE("walk: a lens") {
  check(lone("a lens", csg(lens_piece(0.6))));
}
TEST_CASE("walk: a sphere less a sphere") {
  check(lone("a sphere less a sphere", minus(sphere(), at(sphere(), 0.8, {0.5, 0, 0}))));
}
TEST_CASE("walk: a nested tree") {
  check(tree());
}
TEST_CASE("walk: two boxes that share a face") {
  check(two_boxes());
}
TEST_CASE("walk: a cemented doublet") {
  check(doublet());
}
TEST_CASE("walk: a shell and the ball that fills it") {
  check(filled_shell());
}
TEST_CASE("walk: overlapping solids with priorities") {
  check(overlapping());
}
TEST_CASE("walk: squares on and inside a box") {
  check(squares());
}
TEST_CASE("walk: a corner of three walls") {
  check(room());
}
TEST_CASE("walk: a cylinder, a cone, and what is between") {
  for (const double top : {0.0, 0.3, 1.0, 1.7})
    check(lone("a tapered cylinder", tapered_cylinder(top)), 50000);
}
TEST_CASE("walk: a bored cylinder") {
  check(lone("a bored cylinder", minus(at(tapered_cylinder(0.7), 1.0, {0, 0, -0.5}),
                                       at(tapered_cylinder(0.7), 0.6, {0, 0, -0.3}))));
}
TEST_CASE("walk: cylinders and cones that touch") {
  check(cylinders());
}
TEST_CASE("walk: solids on an endless plane") {
  check(ground());
}
