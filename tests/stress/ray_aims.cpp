#include "tests/stress/ray_aims.h"

#include <cmath>
#include <limits>

namespace abbe::stress {
namespace {

/// Moved by a few units in the last place, or not.
double nudged(double value, Random& random) {
  for (int i = random.below(4); i > 0; --i)
    value = std::nextafter(value, random.chance(0.5) ? kInfinity : -kInfinity);
  return value;
}
dvec3 nudged(const dvec3& v, Random& random) {
  const double x = nudged(v.x, random), y = nudged(v.y, random);
  return {x, y, nudged(v.z, random)};
}

/// A distance from nothing to a thousandth, mostly tiny.
double tiny(Random& random) {
  if (random.chance(0.25)) return 0.0;
  return (random.chance(0.5) ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-18.0, -3.0));
}

} // namespace

RayAims::RayAims(const RayScene& scene, const World& world, RayJudge& judge, double far,
                 Random& random)
    : scene_(scene), world_(world), judge_(judge), far_(far), random_(random) {
  gather_points();
  gather_corners();
  gather_edges();
}

dvec3 RayAims::outside() {
  const double distance = random_.chance(0.5) ? 3.0 : random_.uniform(1.0, far_ / 2.0);
  return scene_.middle + random_.direction() * (distance * scene_.size);
}

dvec3 RayAims::anywhere() {
  return scene_.middle + random_.in_cube(1.2 * scene_.size);
}

void RayAims::gather_points() {
  for (int i = 0; i < 60; ++i) {
    RayState state;
    state.ray.origin = outside();
    state.ray.direction = glm::normalize(anywhere() - state.ray.origin);
    state.nesting = world_.nesting_at(state.ray.origin);
    const auto hit = world_.closest(state);
    if (hit) points_.push_back({hit->point, hit->normal, hit->going_on({}, false).contacts[0]});
  }
}

void RayAims::gather_corners() {
  for (const PlacedShape& placed : world_.shapes()) {
    const auto add = [&](const dvec3& local) { edges_.push_back(placed.to_world.point(local)); };
    if (const auto* solid = std::get_if<ConvexPolyhedron>(&placed.shape))
      for (const dvec3& v : solid->vertices())
        add(v);
    if (std::holds_alternative<Box>(placed.shape))
      for (int i = 0; i < 8; ++i)
        add({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    if (const auto* mesh = std::get_if<Mesh>(&placed.shape))
      for (int i = 0; i < 20; ++i) {
        const auto [a, b, c] =
            mesh->corners(random_.below(static_cast<int>(mesh->triangles().size())));
        add(a);
        add(a + random_.uniform(0.0, 1.0) * (b - a));
      }
  }
}

/// Between two targets at which a ray meets different faces lies one at which that changes.
void RayAims::gather_edges() {
  const auto met = [&](const dvec3& o, const dvec3& target) {
    const dvec3 d = glm::normalize(target - o);
    const auto& ahead = judge_.ahead(Vec(o), Vec(d));
    return ahead.empty() ? SceneCrossing{} : ahead[0];
  };
  const auto same = [](const SceneCrossing& a, const SceneCrossing& b) {
    return a.shape == b.shape && a.crossing.face == b.crossing.face &&
           a.crossing.entering == b.crossing.entering;
  };
  for (int i = 0; i < 24; ++i) {
    const dvec3 o = random_.chance(0.5) ? outside() : anywhere();
    dvec3 low = anywhere(), high = random_.chance(0.3) ? outside() : anywhere();
    SceneCrossing at_low = met(o, low), at_high = met(o, high);
    if (same(at_low, at_high)) continue;
    for (int step = 0; step < 56; ++step) {
      const dvec3 middle = 0.5 * (low + high);
      const SceneCrossing at = met(o, middle);
      if (same(at, at_low))
        low = middle;
      else
        high = middle, at_high = at;
    }
    for (const auto& [target, crossing] : {std::pair(low, at_low), std::pair(high, at_high)}) {
      const Ray ray{o, glm::normalize(target - o)};
      grazing_.push_back(ray);
      if (crossing.shape >= 0)
        edges_.push_back(o + double(met(o, target).crossing.t) * ray.direction);
    }
  }
}

std::optional<AimedRay> RayAims::free(const char* kind, const dvec3& origin,
                                      const dvec3& direction) {
  const double length = glm::length(direction);
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  RayState state;
  state.ray = {origin, direction / length};
  state.nesting = world_.nesting_at(origin);
  // On a surface, within rounding, a ray must be told what it lies on.
  for (const ExactBody& body : judge_.bodies()) {
    const Real blur = 4 * body.blur(Vec(origin), 0);
    if (body.comes_near(Vec(origin), blur)) return std::nullopt;
    if (!body.solid() && body.distance({}, Vec(origin)) < blur) return std::nullopt;
  }
  return AimedRay{kind, state};
}

/// Along a surface, a little above or below it.
std::optional<AimedRay> RayAims::tangent() {
  if (points_.empty()) return std::nullopt;
  const SurfacePoint& at =
      points_[static_cast<std::size_t>(random_.below(static_cast<int>(points_.size())))];
  const dvec3 along = glm::normalize(glm::cross(at.normal, random_.direction()));
  const dvec3 d = glm::normalize(along + tiny(random_) * at.normal);
  const dvec3 passes = at.point + tiny(random_) * scene_.size * at.normal;
  return free("tangent", passes - random_.uniform(0.5, 4.0) * scene_.size * d, d);
}

/// In the direction of an axis of a shape, or in one of its faces' planes.
std::optional<AimedRay> RayAims::parallel() {
  const auto& shapes = world_.shapes();
  const PlacedShape& placed =
      shapes[static_cast<std::size_t>(random_.below(static_cast<int>(shapes.size())))];
  dvec3 local(0.0);
  local[random_.below(3)] = random_.chance(0.5) ? 1.0 : -1.0;
  dvec3 target = random_.in_cube(1.2);
  if (random_.chance(0.3)) target[random_.below(3)] = random_.chance(0.5) ? 1.0 : -1.0;
  const dvec3 d = placed.to_world.vector(local);
  return free("parallel", placed.to_world.point(target - random_.uniform(2.0, 4.0) * local), d);
}

/// Through an edge or a corner, from anywhere.
std::optional<AimedRay> RayAims::at_edge() {
  if (!grazing_.empty() && random_.chance(0.4)) {
    const Ray& ray =
        grazing_[static_cast<std::size_t>(random_.below(static_cast<int>(grazing_.size())))];
    return free("grazing", ray.origin, nudged(ray.direction, random_));
  }
  if (edges_.empty()) return std::nullopt;
  const dvec3& edge =
      edges_[static_cast<std::size_t>(random_.below(static_cast<int>(edges_.size())))];
  const dvec3 o = random_.chance(0.5) ? outside() : anywhere();
  return free("edge", o, nudged(edge, random_) - o);
}

/// From exactly on the surface, or from an edge.
std::optional<AimedRay> RayAims::from_surface() {
  const bool edge = !edges_.empty() && random_.chance(0.3);
  if (edge || points_.empty()) {
    if (edges_.empty()) return std::nullopt;
    const dvec3& o =
        edges_[static_cast<std::size_t>(random_.below(static_cast<int>(edges_.size())))];
    return AimedRay{"from_edge", world_.start_at({o, random_.direction()})};
  }
  const SurfacePoint& at =
      points_[static_cast<std::size_t>(random_.below(static_cast<int>(points_.size())))];
  dvec3 d = random_.direction();
  if (random_.chance(0.3)) // hardly off the surface
    d = glm::normalize(glm::cross(at.normal, d) + std::abs(tiny(random_)) * at.normal);
  if (random_.chance(0.5)) return AimedRay{"from_surface", world_.start_at({at.point, d})};
  SurfaceContact contact = at.contact;
  const double outwards = glm::dot(d, at.normal);
  if (outwards == 0.0) return std::nullopt;
  contact.side = outwards > 0.0 ? Side::outside : Side::inside;
  const auto state = world_.start_on(contact, {at.point, d});
  if (!state) return std::nullopt;
  return AimedRay{"from_surface", *state};
}

/// Zeros of either sign, denormal and tiny components, origins far beyond all.
std::optional<AimedRay> RayAims::odd_numbers() {
  const auto odd = [&]() -> double {
    constexpr double kOdd[] = {0.0,     -0.0,   std::numeric_limits<double>::denorm_min(),
                               -1e-310, 1e-300, 1e-160,
                               -1e-30,  1e-17};
    return kOdd[random_.below(8)];
  };
  dvec3 o = outside(), d = anywhere() - o;
  if (random_.chance(0.3)) { // as far as a ray may come from
    o = scene_.middle +
        random_.direction() * (scene_.size * std::pow(10.0, random_.uniform(2.0, 12.0)));
    return free("huge", o, anywhere() - o);
  }
  const int axis = random_.below(3);
  if (random_.chance(0.5)) {
    d[axis] = odd();
    if (random_.chance(0.4)) d[(axis + 1) % 3] = odd();
    o = anywhere() - 3.0 * d;
  } else {
    o[axis] = odd();
  }
  return free("odd_numbers", o, d);
}

std::optional<AimedRay> RayAims::next() {
  switch (random_.below(8)) {
  case 0: {
    const dvec3 o = outside();
    return free("random", o, anywhere() - o);
  }
  case 1:
    return free("inside", anywhere(), random_.direction());
  case 2:
    return tangent();
  case 3:
    return parallel();
  case 4:
  case 5:
    return at_edge();
  case 6:
    return from_surface();
  default:
    return odd_numbers();
  }
}

} // namespace abbe::stress
