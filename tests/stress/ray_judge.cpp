#include "tests/stress/ray_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace abbe::stress {
namespace {

bool is_in(const Nesting& nesting, std::size_t shape) {
  return std::any_of(nesting.begin(), nesting.end(),
                     [&](ShapeId id) { return id.index() == shape; });
}

std::string hex(const dvec3& v) {
  return fmt::format("({:a},{:a},{:a})", v.x, v.y, v.z);
}

/// The face is plane, so that a straight line crosses it once at most.
bool is_plane(const PlacedShape& placed, FaceId face) {
  return std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (std::is_same_v<S, Sphere>) {
          return false;
        } else if constexpr (std::is_same_v<S, TaperedCylinder>) {
          return face.face != 0;
        } else if constexpr (std::is_same_v<S, CsgTree>) {
          const CsgLeaf& leaf = shape.leaves()[static_cast<std::size_t>(face.leaf)];
          return !std::holds_alternative<Sphere>(leaf.solid) &&
                 (!std::holds_alternative<TaperedCylinder>(leaf.solid) || face.face != 0);
        } else {
          return true;
        }
      },
      placed.shape);
}

} // namespace

RayJudge::RayJudge(const RayScene& scene, const World& world, std::uint64_t round, Tally& tally)
    : world_(world), tally_(tally), name_(scene.name), round_(round), extent_(10 * scene.size) {
  for (const PlacedShape& shape : world.shapes())
    bodies_.emplace_back(shape);
}

const std::vector<SceneCrossing>& RayJudge::ahead(const Vec& origin, const Vec& direction) {
  ahead_.clear();
  crossed_.clear();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    found_.clear();
    bodies_[i].crossings(origin, direction, found_);
    for (const ExactCrossing& c : found_) {
      crossed_.push_back({static_cast<int>(i), c});
      if (c.t > 0) ahead_.push_back(crossed_.back());
    }
  }
  std::stable_sort(
      ahead_.begin(), ahead_.end(),
      [](const SceneCrossing& a, const SceneCrossing& b) { return a.crossing.t < b.crossing.t; });
  return ahead_;
}

Real RayJudge::blur(std::size_t shape, const Vec& origin, Real t) const {
  return std::max(came_with_, bodies_[shape].blur(origin, t));
}

void RayJudge::look(const RayState& state, Real t) {
  const Vec o(state.ray.origin), p = o + t * Vec(state.ray.direction);
  place_.certain = true;
  place_.inside.assign(bodies_.size(), false);
  // So close to where the line meets a surface at a grazing angle that its bound holds the place.
  for (const auto& [shape, c] : crossed_) {
    const ExactBody& body = bodies_[static_cast<std::size_t>(shape)];
    const Vec n = body.normal(c.face, o + c.t * Vec(state.ray.direction));
    const Real cosine = std::abs(glm::dot(n, Vec(state.ray.direction)));
    if (std::abs(t - c.t) * cosine <= 4 * blur(static_cast<std::size_t>(shape), o, c.t)) {
      place_.certain = false;
      tally_.count("places_near_a_surface");
      return;
    }
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].solid()) continue;
    // Where the ray starts on surfaces its origin is off by as much again for each.
    const int times = state.contacts.empty() ? 2 : 8;
    if (bodies_[i].comes_near(p, times * blur(i, o, t))) {
      place_.certain = false;
      tally_.count("places_near_a_surface");
      return;
    }
    place_.inside[i] = bodies_[i].contains(p);
  }
  tally_.count("places");
}

MediumId RayJudge::medium() const {
  MediumId found;
  int highest = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const PlacedShape& shape = world_.shapes()[i];
    if (!place_.inside[i] || !shape.medium.valid()) continue;
    if (found.valid() && shape.priority < highest) continue;
    found = shape.medium;
    highest = shape.priority;
  }
  return found;
}

bool RayJudge::same_solids(const Nesting& nesting) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (place_.inside[i] != is_in(nesting, i)) return false;
  return true;
}

void RayJudge::check_before(const RayState& state, const Hit& hit) {
  const Real end =
      hit.met() ? Real(hit.t) : (ahead_.empty() ? 0 : ahead_.back().crossing.t) + extent_;
  Real from = 0;
  for (std::size_t i = 0; i <= ahead_.size(); ++i) {
    const bool last = i == ahead_.size() || ahead_[i].crossing.t >= end;
    const Real to = last ? end : ahead_[i].crossing.t;
    // Not half-way: between parallel faces that is on other faces' planes too often.
    look(state, from + 0.4142L * (to - from));
    from = to;
    if (place_.certain) {
      for (std::size_t k = 0; k < bodies_.size(); ++k)
        if (bodies_[k].solid() && !world_.shapes()[k].medium.valid() &&
            place_.inside[k] != is_in(state.nesting, k))
          return fail("missed_opaque", state, hit);
      if (medium() != world_.medium_of(state.nesting)) return fail("missed_medium", state, hit);
      if (last && hit.met() && !same_solids(hit.nesting_before))
        return fail("wrong_before", state, hit);
    }
    if (last) return;
  }
}

void RayJudge::check_behind(const RayState& state, const Hit& hit, const ExactCrossing& same,
                            Real error) {
  // The next crossing must lie so far behind that rounding puts nothing between, and no other one
  // so close before that rounding may put it behind.
  Real to = same.t + extent_;
  for (const auto& [shape, c] : crossed_) {
    const bool itself = shape == hit.shape.value && c.t == same.t && c.face == same.face;
    if (!itself && std::abs(c.t - same.t) < 8 * error) return;
    if (c.t > same.t) to = std::min(to, c.t);
  }
  const Vec p(hit.point);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (i != hit.shape.index() && bodies_[i].comes_near(p, 4 * blur(i, p, hit.t))) return;
  look(state, same.t + 0.4142L * (to - same.t));
  if (!place_.certain || same_solids(hit.nesting_after())) return;
  fail("wrong_behind", state, hit);
}

void RayJudge::check_flat_ones(const RayState& state, const Hit& hit) {
  const Vec o(state.ray.origin), d(state.ray.direction);
  for (const auto& [shape, c] : ahead_) {
    const auto i = static_cast<std::size_t>(shape);
    if (bodies_[i].solid()) continue;
    const Real cosine = std::abs(glm::dot(bodies_[i].normal({}, o), d));
    const Real blur = 2 * this->blur(i, o, c.t);
    if (c.t < blur / cosine) continue;
    Real hit_blur = 0;
    if (hit.met()) {
      const auto h = hit.shape.index();
      hit_blur = 2 * this->blur(h, o, hit.t) / std::abs(glm::dot(Vec(hit.normal), d));
      if (c.t > Real(hit.t) - blur / cosine - hit_blur) continue;
    }
    if (bodies_[i].inside_rim(o + c.t * d) < blur * (1 + 1 / cosine)) {
      tally_.count("rims_near");
      continue;
    }
    fail("missed_flat", state, hit);
  }
}

void RayJudge::check_hit(const RayState& state, const Hit& hit) {
  const std::size_t shape = hit.shape.index();
  const ExactBody& body = bodies_[shape];
  const Vec o(state.ray.origin), p(hit.point), n(hit.normal);
  if (!(hit.t >= 0.0) || !std::isfinite(hit.t)) return fail("behind", state, hit);
  if (body.solid() && hit.entering == is_in(hit.nesting_before, shape))
    return fail("not_in_turn", state, hit);
  const Real blur = this->blur(shape, o, hit.t);
  const Real off = body.distance(hit.face, p);
  tally_.worst("point_off_surface_in_blurs", static_cast<double>(off / blur));
  if (!(off <= blur)) fail("point_off_surface", state, hit);
  // A grazed surface is near the line for long; else the point is where the line is.
  const Vec truth = body.normal(hit.face, p);
  const Real away = glm::length(p - o - Real(hit.t) * Vec(state.ray.direction));
  const Real slope = std::abs(glm::dot(truth, Vec(state.ray.direction)));
  const Real sure = (state.contacts.empty() ? 4 : 64) * blur;
  if (away > sure && away * slope > sure) {
    // Known and open, see docs/stability.md: a ray that grazes an edge of a mesh leaves at once, by
    // a face that is not the nearest, and is put there. What follows is judged no more.
    if (Real(hit.t) <= sure && std::holds_alternative<Mesh>(world_.shapes()[shape].shape))
      return open("open_jump_at_an_edge");
    fail("point_off_line", state, hit);
  }
  const Real turn = glm::length(n - truth) - body.turn(hit.face, p, blur);
  tally_.worst("normal_error", static_cast<double>(std::max(turn, Real(0))));
  if (!(turn <= 1e-6L)) fail("normal", state, hit);
  const Real outwards = glm::dot(n, Vec(state.ray.direction));
  if (hit.entering ? outwards > 1e-6L + body.turn(hit.face, p, blur)
                   : outwards < -1e-6L - body.turn(hit.face, p, blur))
    fail("normal_side", state, hit);
  if (!state.contacts.empty()) {
    const SurfaceContact& left = state.contacts[0];
    // A ray that stays in the face's plane, within rounding, for as long as the scene is large may
    // be on either side of it.
    const bool crosses = std::abs(outwards) * extent_ / 10 > 2 * blur;
    if (left.shape == hit.shape && left.face == hit.face && crosses &&
        is_plane(world_.shapes()[shape], hit.face))
      fail("self_hit", state, hit);
  }
  check_distance(state, hit);
}

void RayJudge::check_distance(const RayState& state, const Hit& hit) {
  const PlacedShape& placed = world_.shapes()[hit.shape.index()];
  ShapeState known;
  known.inside = is_solid(placed.shape) && is_in(state.nesting, hit.shape.index());
  for (const SurfaceContact& contact : state.contacts)
    if (contact.shape == hit.shape) {
      known = {contact.side == Side::inside, true, contact.face, {}};
      break;
    }
  const LocalRay in_world{state.ray.origin, state.ray.direction};
  const bool tree = std::holds_alternative<CsgTree>(placed.shape); // its leaves are in the world
  const LocalRay ray = tree ? in_world : local_ray(placed.to_world, in_world);
  const auto next =
      std::visit([&](const auto& shape) { return next_crossing(shape, ray, known); }, placed.shape);
  // Behind a boundary that does not show, or where several coincide, the distance is another's.
  if (!next || next->t != hit.t || !(next->face == hit.face)) return tally_.count("t_of_others");
  Real nearest = INFINITY;
  const ExactCrossing* same = nullptr;
  // Rounding may have put it at the origin where it lies behind.
  for (const auto& [shape, c] : crossed_)
    if (shape == hit.shape.value && c.face == hit.face && c.entering == hit.entering &&
        std::abs(c.t - Real(hit.t)) < nearest) {
      nearest = std::abs(c.t - Real(hit.t));
      same = &c;
    }
  const Real blur = this->blur(hit.shape.index(), Vec(state.ray.origin), hit.t);
  // Known to leave at once: the root is 0 by definition, and whether it does is seen behind it.
  if (next->t <= next->t_error && known.touching) return tally_.count("t_by_definition");
  if (!same || nearest > Real(next->t_error)) {
    // By now the place is known to be on the line and on the face's surface. At an edge the face
    // may reach that far when rounding moves the others.
    if (bodies_[hit.shape.index()].may_show(hit.face, Vec(hit.point), 2 * blur))
      return tally_.count("t_at_an_edge");
    return fail(same ? "t" : "ghost", state, hit);
  }
  tally_.count(known.touching ? "t_from_a_surface" : "t_from_free");
  if (nearest > 0)
    tally_.worst("t_error_in_bounds", static_cast<double>(nearest / Real(next->t_error)));
  const Real cosine = std::abs(glm::dot(Vec(hit.normal), Vec(state.ray.direction)));
  if (cosine > 0.1L && Real(next->t_error) * cosine > 4 * blur) fail("bound_too_wide", state, hit);
  check_behind(state, hit, *same, Real(next->t_error));
}

void RayJudge::check(const RayState& state, const Hit& hit, bool behind_others) {
  judge(state, hit, behind_others);
  if (hit.met()) came_with_ = blur(hit.shape.index(), Vec(state.ray.origin), hit.t);
  previous_ = {state, hit};
}

void RayJudge::open(const char* what) {
  tally_.count(what);
  spoilt_ = true;
}

void RayJudge::judge(const RayState& state, const Hit& hit, bool behind_others) {
  tally_.count("rays");
  tally_.count(std::string("rays_") + kind_);
  tally_.count(std::string("scene_") + name_);
  // A ray all but along a plane may be said to lie on what it met beside it.
  for (const SurfaceContact& c : state.contacts) {
    const ExactBody& body = bodies_[c.shape.index()];
    const Vec o(state.ray.origin);
    if (body.distance(c.face, o) > 64 * blur(c.shape.index(), o, 0))
      return fail("contact_off_its_surface", state, hit);
  }
  ahead(Vec(state.ray.origin), Vec(state.ray.direction));
  check_before(state, hit);
  check_flat_ones(state, hit);
  if (!hit.met()) return;
  if (!behind_others) check_hit(state, hit);
}

void RayJudge::check_occluded(const RayState& state, const Hit& hit, double distance) {
  const bool answer = world_.occluded(state, distance);
  tally_.count("shadow_rays");
  if (!hit.met()) {
    if (answer) fail("shadow_of_nothing", state, hit);
    return;
  }
  const Real cosine = std::abs(glm::dot(Vec(hit.normal), Vec(state.ray.direction)));
  const Real blur = 4 * this->blur(hit.shape.index(), Vec(state.ray.origin), hit.t) / cosine;
  const Real beyond = Real(distance) - Real(hit.t);
  if (beyond > blur && beyond > std::sqrt(blur) && !answer) fail("no_shadow", state, hit);
  if (beyond < -blur && answer) fail("shadow_too_far", state, hit);
}

void RayJudge::check_nesting(const dvec3& place, const Nesting& nesting) {
  RayState at;
  at.ray = {place, {0.0, 0.0, 1.0}};
  crossed_.clear();
  look(at, 0);
  if (place_.certain && !same_solids(nesting)) fail("nesting", at, Hit());
}

namespace {

std::string told(const RayState& state, const Hit& hit) {
  std::string contacts, solids;
  for (const SurfaceContact& c : state.contacts)
    contacts += fmt::format("{}/{}/{}{} ", c.shape.value, c.face.leaf, c.face.face,
                            c.side == Side::inside ? "in" : "out");
  for (const ShapeId id : state.nesting)
    solids += fmt::format("{} ", id.value);
  const std::string ray = fmt::format("o {} d {} on [{}] in [{}] met ", hex(state.ray.origin),
                                      hex(state.ray.direction), contacts, solids);
  if (!hit.met()) return ray + "nothing";
  return ray + fmt::format("{}/{}/{} {} at {:a}", hit.shape.value, hit.face.leaf, hit.face.face,
                           hit.entering ? "entering" : "leaving", hit.t);
}

} // namespace

void RayJudge::fail(const char* what, const RayState& state, const Hit& hit) {
  tally_.fail(what, fmt::format("round {} scene {} kind {} {}{}{}", round_, name_, kind_,
                                told(state, hit), previous_ ? ", before that " : "",
                                previous_ ? told(previous_->first, previous_->second) : ""));
}

} // namespace abbe::stress
