#include "geometry/world/world.h"

#include "geometry/rays/finite_ray.h"
#include "geometry/rays/largest_component.h"
#include "geometry/world/shape_at_place.h"
#include "geometry/world/world_callbacks.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

/// Each coordinate of a ray that Embree sees differs from the double one by at most 2.5 u R at its
/// origin (u = 2^-24, R the farthest coordinate; see `near_origin`) and by u t <= 4 u R at distance
/// t <= 2 sqrt(3) R; the slab test adds a few u of differences up to 3.5 R. 16 u R covers the sum.
double bounds_padding(double farthest_coordinate) {
  return std::ldexp(farthest_coordinate, -20);
}

/// Where Embree's ray begins if that is far off. One that starts on an endless plane, beyond the
/// bounded shapes, begins where it comes near them: they lie in a ball of radius sqrt(3) R about
/// the origin, and the place where the ray enters it has coordinates below sqrt(6) R < 2.5 R.
/// Planes are met from anywhere.
dvec3 moved_near(const Ray& ray, double farthest_coordinate) {
  const double advance =
      -glm::dot(ray.origin, ray.direction) - std::numbers::sqrt3 * farthest_coordinate;
  // Embree takes no coordinate above 1.8e18 (Debian's ends the program). A ray that has gone so
  // far meets planes alone, and those from anywhere.
  constexpr double kFarthest = 5e17; // in the box of a plane
  return glm::clamp(advance > 0.0 ? ray.at(advance) : ray.origin, -kFarthest, kFarthest);
}

dvec3 near_origin(const Ray& ray, double farthest_coordinate) {
  const dvec3& o = ray.origin;
  const double farthest = std::max(std::max(std::abs(o.x), std::abs(o.y)), std::abs(o.z));
  return farthest <= farthest_coordinate ? o : moved_near(ray, farthest_coordinate);
}

/// A ray for Embree, written as it reads it: by four floats. Single stores would have to reach the
/// cache before they could be read together.
void set_ray(RTCRay& out, const Ray& ray, double farthest_coordinate, float tfar) {
  using Floats = float __attribute__((vector_size(16)));
  struct Vectors {
    Floats origin_tnear, direction_time;
  };
  const dvec3 o = near_origin(ray, farthest_coordinate);
  const dvec3& d = ray.direction;
  const Vectors vectors{__builtin_convertvector((Wide{o.x, o.y, o.z, 0.0}), Floats),
                        __builtin_convertvector((Wide{d.x, d.y, d.z, 0.0}), Floats)};
  static_assert(offsetof(RTCRay, tfar) == sizeof vectors);
  std::memcpy(&out, &vectors, sizeof vectors);
  out.tfar = tfar;
  out.mask = ~0u;
  out.id = 0;
  out.flags = 0;
}

/// In packets Embree (3.13.5) goes by the sign of a component of the direction, but takes one below
/// 1e-18 for +1e-18: a tiny negative one loses other rays of the packet. Zero has no sign for it,
/// and moves the ray by less than the bounds are padded by.
float direction_in_packet(double component) {
  const auto rounded = static_cast<float>(component);
  return std::abs(rounded) < 1e-17f ? 0.0f : rounded;
}

template <class Packet>
void set_ray(Packet& out, unsigned i, const Ray& ray, double farthest_coordinate, float tfar) {
  const dvec3 origin = near_origin(ray, farthest_coordinate);
  out.org_x[i] = static_cast<float>(origin.x);
  out.org_y[i] = static_cast<float>(origin.y);
  out.org_z[i] = static_cast<float>(origin.z);
  out.dir_x[i] = direction_in_packet(ray.direction.x);
  out.dir_y[i] = direction_in_packet(ray.direction.y);
  out.dir_z[i] = direction_in_packet(ray.direction.z);
  out.tnear[i] = 0.0f;
  out.tfar[i] = tfar;
  out.time[i] = 0.0f;
  out.mask[i] = ~0u;
  out.id[i] = i;
  out.flags[i] = 0;
}

constexpr std::size_t kWidest = 16;

/// Traces the first `count` of the query's rays. The mask alone does not keep the other lanes out:
/// Embree ignores it where it has to trace a packet in narrower pieces, since the processor (or the
/// device's configuration) has no registers of that width. An interval that ends before it begins
/// keeps them out, so no callback asks for the state of a ray that is not there.
template <class Packet, std::size_t Width>
void trace_packet(RTCScene scene, Query& query, std::size_t count) {
  constexpr float kNowhere = -1.0f;
  alignas(64) std::array<int, Width> valid{};
  alignas(64) Packet packet;
  const float tfar = rounded_up(query.distance);
  const Ray any;
  for (std::size_t i = 0; i < Width; ++i) {
    const bool used = i < count && is_finite(query.states[i].ray);
    valid[i] = used ? -1 : 0;
    set_ray(packet.ray, static_cast<unsigned>(i), used ? query.states[i].ray : any,
            query.farthest_coordinate, used ? tfar : kNowhere);
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  embree::intersect(valid.data(), scene, query.context, packet);
}

void trace_single(RTCScene scene, Query& query) {
  if (!is_finite(query.states[0].ray)) return;
  RTCRayHit ray;
  set_ray(ray.ray, query.states[0].ray, query.farthest_coordinate, rounded_up(query.distance));
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(scene, query.context, ray);
}

/// Places the leaves of every tree in the world, so that one transform per leaf remains.
std::vector<PlacedShape> flattened(std::vector<PlacedShape> shapes) {
  for (PlacedShape& placed : shapes)
    if (auto* tree = std::get_if<CsgTree>(&placed.shape)) {
      *tree = tree->moved(placed.to_world);
      placed.to_world = Transform();
    }
  return shapes;
}

} // namespace

struct World::Impl {
  std::vector<PlacedShape> shapes;
  ShapeTable table;
  ShapeGroups groups;
  std::vector<const ShapeGroup*> attached; ///< by Embree's number of the geometry
  std::vector<double> surface_errors;      ///< by shape, see surface_error()
  double farthest_coordinate; ///< of the bounded shapes, and of all places where rays begin
  std::string error;          ///< Embree's, while the world is built
  embree::Device device;
  embree::Scene scene;

  Impl(const std::vector<PlacedShape>& placed, double farthest_origin, const char* embree_config);
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] Query query_for(const RayState* states, NearestCandidates* found,
                                double distance) const {
    Query query{{}, states, found, farthest_coordinate, distance};
    embree::init(query.context);
    return query;
  }
  [[nodiscard]] NearestCandidates nearest(const RayState& state, double distance,
                                          const Passage* passage) const;
  void find_closest(const RayState& state, double distance, Passage* passage, Hit& hit) const;
  void find_visible(const RayState& start, const NearestCandidates& nearest, double distance,
                    Passage* passage, Hit& hit) const;
  void go_on_behind(const RayState& start, double distance, Passage& passage, Hit& hit) const;

  /// The shapes whose boxes come within a distance of a place, and endless ones, in their order.
  [[nodiscard]] Nesting shapes_near(const dvec3& place, double distance) const;
  /// Calls `visit` for the other shapes whose boxes touch that of a shape.
  template <class Visit>
  void for_each_beside(ShapeId shape, Visit&& visit) const;
  /// Adds what lies at the beginning of a ray to its state: contacts and solids, those of `on`
  /// aside. False where a surface that shows before that of `on` is there.
  [[nodiscard]] bool begin(ShapeId on, double place_error, RayState& state) const;
};

World::Impl::Impl(const std::vector<PlacedShape>& placed, double farthest_origin,
                  const char* embree_config)
    : shapes(flattened(placed)), table(shapes), farthest_coordinate(farthest_origin),
      device(rtcNewDevice(embree_config)) {
  if (!device) throw std::runtime_error("Embree: cannot make a device");
  rtcSetDeviceErrorFunction(
      device.get(),
      [](void* self, RTCError, const char* message) {
        static_cast<Impl*>(self)->error = message ? message : "unknown error";
      },
      this);
  surface_errors.reserve(shapes.size());
  for (const PlacedShape& shape : shapes) {
    surface_errors.push_back(surface_error(shape));
    if (is_bounded(shape.shape))
      farthest_coordinate = std::max(farthest_coordinate, bounds(shape).largest_coordinate());
  }
  groups.fill({{}, bounds_padding(farthest_coordinate)});
  for (std::size_t i = 0; i < shapes.size(); ++i)
    groups[shapes[i].shape.index()].primitives.emplace_back(shapes[i],
                                                            ShapeId{static_cast<std::int32_t>(i)});
  [[maybe_unused]] const FloatTraps off(false);
  scene.reset(rtcNewScene(device.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  attach(groups, device.get(), scene.get());
  for (const ShapeGroup& group : groups)
    if (!group.primitives.empty()) attached.push_back(&group);
  rtcCommitScene(scene.get());
  if (!error.empty()) throw std::runtime_error("Embree: " + error);
}

NearestCandidates World::Impl::nearest(const RayState& state, double distance,
                                       const Passage* passage) const {
  NearestCandidates found;
  Query query = query_for(&state, &found, distance);
  query.passage = passage;
  trace_single(scene.get(), query);
  return found;
}

void World::Impl::find_closest(const RayState& state, double distance, Passage* passage,
                               Hit& hit) const {
  find_visible(state, nearest(state, distance, passage), distance, passage, hit);
}

/// Turns the nearest candidates into what is visible.
void World::Impl::find_visible(const RayState& start, const NearestCandidates& nearest,
                               double distance, Passage* passage, Hit& hit) const {
  if (nearest.empty()) {
    hit.shape = {};
  } else if (!resolve(table, start, nearest.boundary(), hit)) {
    Passage own;
    go_on_behind(start, distance, passage ? *passage : own, hit);
  }
}

/// Goes on behind `hit`, which does not show, to the first boundary that does, or to one behind
/// which the ray cannot go on.
void World::Impl::go_on_behind(const RayState& start, double distance, Passage& passage,
                               Hit& hit) const {
  RayState state = start;
  double travelled = 0.0;
  bool visible = false;
  while (!visible && passage.go_through(hit, state)) {
    travelled += hit.t;
    const NearestCandidates next = nearest(state, distance - travelled, &passage);
    if (next.empty()) {
      hit.shape = {};
      return;
    }
    visible = resolve(table, state, next.boundary(), hit);
  }
  hit.t += travelled;
}

World::World(const std::vector<PlacedShape>& shapes, double farthest_coordinate,
             const char* embree_config)
    : impl_(std::make_unique<Impl>(shapes, farthest_coordinate, embree_config)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

std::optional<Hit> World::closest(const RayState& state) const {
  Hit hit;
  find_closest(state, hit);
  return hit.met() ? std::optional(hit) : std::nullopt;
}

void World::find_closest(const RayState& state, Hit& hit) const {
  impl_->find_closest(state, kInfinity, nullptr, hit);
}

void World::find_closest(const RayState& state, double distance, Passage& passage, Hit& hit) const {
  impl_->find_closest(state, distance, &passage, hit);
}

void World::find_closest(std::span<const RayState> states, std::span<Hit> hits,
                         Tracing tracing) const {
  for (std::size_t begin = 0; begin < states.size(); begin += kWidest) {
    const std::size_t count = std::min(kWidest, states.size() - begin);
    if (tracing == Tracing::single || count == 1) {
      for (std::size_t i = begin; i < begin + count; ++i)
        find_closest(states[i], hits[i]);
      continue;
    }
    std::array<NearestCandidates, kWidest> nearest;
    Query query = impl_->query_for(&states[begin], nearest.data(), kInfinity);
    if (count <= 4)
      trace_packet<RTCRayHit4, 4>(impl_->scene.get(), query, count);
    else if (count <= 8)
      trace_packet<RTCRayHit8, 8>(impl_->scene.get(), query, count);
    else
      trace_packet<RTCRayHit16, 16>(impl_->scene.get(), query, count);
    for (std::size_t i = 0; i < count; ++i)
      impl_->find_visible(states[begin + i], nearest[i], kInfinity, nullptr, hits[begin + i]);
  }
}

bool World::occluded(const RayState& state, double distance) const {
  if (!is_finite(state.ray)) return true;
  Query query = impl_->query_for(&state, nullptr, distance);
  // Outside all glass the first glass along the ray shows for certain. Inside, boundaries between
  // equal media may come first.
  query.glass_may_hide = medium_of(state.nesting).valid();
  RTCRay ray;
  set_ray(ray, state.ray, query.farthest_coordinate, rounded_up(distance));
  embree::occluded(impl_->scene.get(), query.context, ray);
  if (ray.tfar < 0.0f) return true;
  if (!query.met_glass) return false;
  Hit hit;
  impl_->find_closest(state, distance, nullptr, hit);
  return hit.met();
}

std::size_t World::replay_closest(std::span<const RayState> states, int width) const {
  std::array<NearestCandidates, kWidest> nearest;
  Query query = impl_->query_for(nullptr, nearest.data(), kInfinity);
  std::size_t met = 0;
  for (std::size_t begin = 0; begin < states.size(); begin += static_cast<std::size_t>(width)) {
    const std::size_t count = std::min(static_cast<std::size_t>(width), states.size() - begin);
    query.states = &states[begin];
    for (std::size_t i = 0; i < count; ++i)
      nearest[i].clear();
    if (width == 1)
      trace_single(impl_->scene.get(), query);
    else if (width == 4)
      trace_packet<RTCRayHit4, 4>(impl_->scene.get(), query, count);
    else if (width == 8)
      trace_packet<RTCRayHit8, 8>(impl_->scene.get(), query, count);
    else
      trace_packet<RTCRayHit16, 16>(impl_->scene.get(), query, count);
    for (std::size_t i = 0; i < count; ++i)
      met += nearest[i].empty() ? 0 : 1;
  }
  return met;
}

std::size_t World::replay_occluded(std::span<const RayState> states,
                                   std::span<const double> distances) const {
  std::size_t met = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    Query query = impl_->query_for(&states[i], nullptr, distances[i]);
    RTCRay ray;
    set_ray(ray, states[i].ray, query.farthest_coordinate, rounded_up(distances[i]));
    embree::occluded(impl_->scene.get(), query.context, ray);
    met += ray.tfar < 0.0f ? 1 : 0;
  }
  return met;
}

Nesting World::Impl::shapes_near(const dvec3& place, double distance) const {
  struct Found {
    const Impl& impl;
    Nesting shapes;
  } found{*this, {}};
  RTCPointQuery query;
  query.x = static_cast<float>(place.x);
  query.y = static_cast<float>(place.y);
  query.z = static_cast<float>(place.z);
  query.time = 0.0f;
  // As for rays, the boxes' padding covers what single precision does to the place.
  query.radius = rounded_up(distance);
  RTCPointQueryContext context;
  [[maybe_unused]] const FloatTraps off(false);
  rtcInitPointQueryContext(&context);
  rtcPointQuery(
      scene.get(), &query, &context,
      [](RTCPointQueryFunctionArguments* args) {
        auto& into = *static_cast<Found*>(args->userPtr);
        const ShapeGroup& group = *into.impl.attached[args->geomID];
        into.shapes.push_back(group.primitives[args->primID].id);
        return false; // the radius stays
      },
      &found);
  std::sort(found.shapes.begin(), found.shapes.end());
  return found.shapes;
}

namespace {

bool is_flat(const Shape& shape) {
  return std::visit([]<class S>(const S&) { return FlatShape<S>; }, shape);
}

/// Whether a flat shape's plane runs through a box.
bool runs_through(const PlacedShape& flat, const Bounds& box) {
  const dvec3 normal = flat.to_world.normal({0.0, 0.0, 1.0});
  const dvec3 half = 0.5 * (box.upper - box.lower);
  const double reach = glm::dot(glm::abs(normal), half) + surface_error(flat);
  return std::abs(glm::dot(normal, box.lower + half - flat.to_world.offset())) <= reach;
}

} // namespace

template <class Visit>
void World::Impl::for_each_beside(ShapeId shape, Visit&& visit) const {
  const auto box_of = [&](ShapeId id) {
    const PlacedShape& placed = shapes[id.index()];
    return bounds(placed).grown(surface_error(placed));
  };
  const Bounds box = box_of(shape);
  for (const ShapeId id :
       shapes_near(0.5 * (box.lower + box.upper), 0.5 * glm::length(box.upper - box.lower))) {
    if (id == shape) continue;
    const PlacedShape& other = shapes[id.index()];
    if (is_bounded(other.shape) && box_of(id).overlap(box).empty()) continue;
    if (!is_flat(other.shape) || runs_through(other, box)) visit(id);
  }
}

bool World::Impl::begin(ShapeId on, double place_error, RayState& state) const {
  for (const ShapeId id : shapes_near(state.ray.origin, 0.0)) {
    if (id == on) continue;
    const Departure way = departure(shapes[id.index()], state.ray, place_error);
    if (way.face) {
      if (on.valid() && shows_before(table, id, on)) return false;
      state.contacts.push_back({id, *way.face, way.inside ? Side::inside : Side::outside});
    }
    if (way.inside && table[id].solid) state.nesting.push_back(id);
  }
  return true;
}

Nesting World::nesting_at(const dvec3& point) const {
  Nesting nesting;
  for (const ShapeId id : impl_->shapes_near(point, 0.0))
    if (contains(impl_->shapes[id.index()], point)) nesting.push_back(id);
  return nesting;
}

RayState World::start_at(const Ray& ray) const {
  RayState state{ray, {}, {}};
  (void)impl_->begin({}, 0.0, state);
  return state;
}

std::optional<RayState> World::start_on(const SurfaceContact& contact, const Ray& ray) const {
  RayState state{ray, {}, {}};
  state.contacts.push_back(contact);
  const double error = impl_->surface_errors[contact.shape.index()];
  if (!impl_->begin(contact.shape, error, state)) return std::nullopt;
  if (contact.side == Side::inside && impl_->table[contact.shape].solid)
    state.nesting.push_back(contact.shape);
  return state;
}

bool World::shows(ShapeId shape, std::span<const ShapeId> hiders, const Ray& ray,
                  double distance) const {
  const PlacedShape& placed = impl_->shapes[shape.index()];
  dvec3 place = ray.at(distance);
  if (const auto* ball = std::get_if<Sphere>(&placed.shape))
    place = placed.to_world.point(snapped(*ball, placed.to_world.inverse_point(place), FaceId{}));
  const double error = impl_->surface_errors[shape.index()] +
                       8.0 * kRoundoff * (largest_component(ray.origin) + distance);
  const Ray there{place, ray.direction};
  constexpr std::size_t kFew = 4; // are asked faster than found
  if (hiders.size() <= kFew)
    return std::none_of(hiders.begin(), hiders.end(), [&](ShapeId id) {
      return departure(impl_->shapes[id.index()], there, error).face.has_value();
    });
  RayState state{there, {}, {}};
  return impl_->begin(shape, error, state);
}

bool World::stands_alone(ShapeId shape) const {
  bool alone = true;
  impl_->for_each_beside(shape, [&](ShapeId) { alone = false; });
  return alone;
}

std::vector<ShapeId> World::hiders(ShapeId shape) const {
  std::vector<ShapeId> hiders;
  impl_->for_each_beside(shape, [&](ShapeId other) {
    if (shows_before(impl_->table, other, shape)) hiders.push_back(other);
  });
  return hiders;
}

MediumId World::medium_of(const Nesting& nesting) const {
  return abbe::medium_of(impl_->table, nesting);
}

const std::vector<PlacedShape>& World::shapes() const {
  return impl_->shapes;
}

std::string embree_version() {
  return RTC_VERSION_STRING;
}

} // namespace abbe
