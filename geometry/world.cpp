#include "geometry/world.h"

#include "geometry/boundary.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace abbe {
namespace {

// ---- The two Embree interfaces, told apart here and nowhere else ----

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
void init(EmbreeContext& context) {
  rtcInitRayQueryContext(&context);
}
RTCIntersectArguments intersect_arguments(EmbreeContext& context, bool coherent) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  return arguments;
}
#define ABBE_INTERSECT(width, valid, scene, context, ray)                                          \
  do {                                                                                             \
    auto arguments = intersect_arguments(context, true);                                           \
    rtcIntersect##width(valid, scene, ray, &arguments);                                            \
  } while (false)
void intersect_one(RTCScene scene, EmbreeContext& context, RTCRayHit& ray) {
  auto arguments = intersect_arguments(context, false);
  rtcIntersect1(scene, &ray, &arguments);
}
void occluded_one(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}
#else
using EmbreeContext = RTCIntersectContext;
void init(EmbreeContext& context) {
  rtcInitIntersectContext(&context);
}
#define ABBE_INTERSECT(width, valid, scene, context, ray)                                          \
  do {                                                                                             \
    (context).flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;                                         \
    rtcIntersect##width(valid, scene, &(context), ray);                                            \
  } while (false)
void intersect_one(RTCScene scene, EmbreeContext& context, RTCRayHit& ray) {
  rtcIntersect1(scene, &context, &ray);
}
void occluded_one(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
  rtcOccluded1(scene, &context, &ray);
}
#endif

// ---- What the callbacks see ----

/// One Embree geometry holds all shapes of one type, so a callback need not ask for the type.
struct ShapeGroup {
  const std::vector<PlacedShape>* shapes = nullptr;
  std::vector<ShapeId> ids; ///< by Embree's primitive number
  double padding = 0.0;
};

/// Passed to the callbacks through Embree's context, which must come first.
struct Query {
  EmbreeContext context;
  const RayState* states = nullptr;
  NearestCandidates* found = nullptr; ///< one per ray, for closest hits
  double distance = kInfinity;        ///< for occlusion
};

float rounded_up(double value) {
  if (value >= static_cast<double>(std::numeric_limits<float>::max()))
    return std::numeric_limits<float>::infinity();
  const auto nearest =
      static_cast<float>(value); // not negative: the next float is the next integer
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(nearest) + 1);
}

template <class S>
std::optional<ShapeCrossing> crossing(const PlacedShape& placed, ShapeId id,
                                      const RayState& state) {
  ShapeState known;
  known.inside = std::find(state.nesting.begin(), state.nesting.end(), id) != state.nesting.end();
  for (const SurfaceContact& contact : state.contacts)
    if (contact.shape == id) {
      known.touching = true;
      known.face = contact.face;
      known.inside = contact.side == Side::inside;
    }
  const Ray& ray = state.ray;
  if constexpr (std::is_same_v<S, CsgTree>) // its leaves are placed in the world already
    return next_crossing(std::get<S>(placed.shape), {ray.origin, ray.direction, 0.0}, known);
  const Ray local = placed.to_world.inverse_ray(ray);
  return next_crossing(
      std::get<S>(placed.shape),
      {local.origin, local.direction, placed.to_world.inverse_error(ray.origin, 0.0)}, known);
}

template <class S>
void intersect_callback(const RTCIntersectFunctionNArguments* args) {
  const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
  const auto& query = *reinterpret_cast<const Query*>(args->context);
  const ShapeId id = group.ids[args->primID];
  const PlacedShape& placed = (*group.shapes)[id.index()];
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const unsigned ray = RTCRayN_id(rays, args->N, i);
    const auto found = crossing<S>(placed, id, query.states[ray]);
    if (!found || !query.found[ray].offer({id, *found})) continue;
    float& tfar = RTCRayN_tfar(rays, args->N, i);
    tfar = std::min(tfar, rounded_up(query.found[ray].reach()));
  }
}

template <class S>
void occluded_callback(const RTCOccludedFunctionNArguments* args) {
  const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
  const auto& query = *reinterpret_cast<const Query*>(args->context);
  const ShapeId id = group.ids[args->primID];
  const PlacedShape& placed = (*group.shapes)[id.index()];
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const auto found = crossing<S>(placed, id, query.states[RTCRayN_id(args->ray, args->N, i)]);
    if (found && found->t < query.distance)
      RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
  }
}

void bounds_callback(const RTCBoundsFunctionArguments* args) {
  const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
  const Bounds box = bounds((*group.shapes)[group.ids[args->primID].index()]).grown(group.padding);
  constexpr float inf = std::numeric_limits<float>::infinity();
  const auto down = [](double v) { return std::nextafter(static_cast<float>(v), -inf); };
  const auto up = [](double v) { return std::nextafter(static_cast<float>(v), inf); };
  RTCBounds& out = *args->bounds_o;
  out.lower_x = down(box.lower.x);
  out.lower_y = down(box.lower.y);
  out.lower_z = down(box.lower.z);
  out.upper_x = up(box.upper.x);
  out.upper_y = up(box.upper.y);
  out.upper_z = up(box.upper.z);
}

/// Each coordinate of a ray that Embree sees differs from the double one by at most u R at its
/// origin (u = 2^-24, R the farthest coordinate) and by u t <= 4 u R at distance t <= 2 sqrt(3) R;
/// the slab test adds a few u of differences up to 2 R. 16 u R covers the sum.
double bounds_padding(double farthest_coordinate) {
  return std::ldexp(farthest_coordinate, -20);
}

template <class Embree>
void set_ray(Embree& out, unsigned i, const Ray& ray, float tfar) {
  const auto at = [i](auto& field) -> auto& {
    if constexpr (std::is_array_v<std::remove_reference_t<decltype(field)>>)
      return field[i];
    else
      return field;
  };
  at(out.org_x) = static_cast<float>(ray.origin.x);
  at(out.org_y) = static_cast<float>(ray.origin.y);
  at(out.org_z) = static_cast<float>(ray.origin.z);
  at(out.dir_x) = static_cast<float>(ray.direction.x);
  at(out.dir_y) = static_cast<float>(ray.direction.y);
  at(out.dir_z) = static_cast<float>(ray.direction.z);
  at(out.tnear) = 0.0f;
  at(out.tfar) = tfar;
  at(out.time) = 0.0f;
  at(out.mask) = ~0u;
  at(out.id) = i;
  at(out.flags) = 0;
}

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr std::size_t kWidest = 16;

template <class Packet, std::size_t Width>
void trace_packet(RTCScene scene, Query& query, std::size_t count) {
  alignas(64) std::array<int, Width> valid{};
  alignas(64) Packet packet;
  for (std::size_t i = 0; i < Width; ++i) {
    valid[i] = i < count ? -1 : 0;
    set_ray(packet.ray, static_cast<unsigned>(i), query.states[i < count ? i : 0].ray, kFar);
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  if constexpr (Width == 4) ABBE_INTERSECT(4, valid.data(), scene, query.context, &packet);
  if constexpr (Width == 8) ABBE_INTERSECT(8, valid.data(), scene, query.context, &packet);
  if constexpr (Width == 16) ABBE_INTERSECT(16, valid.data(), scene, query.context, &packet);
}

void trace_single(RTCScene scene, Query& query) {
  RTCRayHit ray;
  set_ray(ray.ray, 0, query.states[0].ray, kFar);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect_one(scene, query.context, ray);
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
  std::array<ShapeGroup, std::variant_size_v<Shape>> groups;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::string error;

  Impl(const std::vector<PlacedShape>& placed, double farthest_coordinate);
  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  template <class S>
  void attach(double padding);
  void check() const {
    if (!error.empty()) throw std::runtime_error("Embree: " + error);
  }
  std::optional<Hit> finish(RayState state, NearestCandidates found) const;
};

template <class S>
void World::Impl::attach(double padding) {
  ShapeGroup group{&shapes, {}, padding};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (std::holds_alternative<S>(shapes[i].shape))
      group.ids.push_back({static_cast<std::int32_t>(i)});
  if (group.ids.empty()) return;
  ShapeGroup& kept =
      groups[Shape(std::in_place_type<S>, std::get<S>(shapes[group.ids[0].index()].shape)).index()];
  kept = std::move(group);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(kept.ids.size()));
  rtcSetGeometryUserData(geometry, &kept);
  rtcSetGeometryBoundsFunction(geometry, bounds_callback, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_callback<S>);
  rtcSetGeometryOccludedFunction(geometry, occluded_callback<S>);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

World::Impl::Impl(const std::vector<PlacedShape>& placed, double farthest_coordinate)
    : shapes(flattened(placed)) {
  device = rtcNewDevice(nullptr);
  if (!device) throw std::runtime_error("Embree: cannot make a device");
  rtcSetDeviceErrorFunction(
      device,
      [](void* self, RTCError, const char* message) {
        static_cast<Impl*>(self)->error = message ? message : "unknown error";
      },
      this);
  for (const PlacedShape& shape : shapes)
    farthest_coordinate = std::max(farthest_coordinate, bounds(shape).largest_coordinate());
  const double padding = bounds_padding(farthest_coordinate);
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  [&]<class... S>(std::type_identity<std::variant<S...>>) {
    (attach<S>(padding), ...);
  }(std::type_identity<Shape>());
  rtcCommitScene(scene);
  check();
}

/// Turns candidates into a hit; passes boundaries that do not show.
std::optional<Hit> World::Impl::finish(RayState state, NearestCandidates found) const {
  double travelled = 0.0;
  while (!found.empty()) {
    Boundary boundary = resolve(shapes, state, found.boundary());
    Hit& hit = boundary.hit;
    if (boundary.visible) {
      hit.t += travelled;
      return hit;
    }
    travelled += hit.t;
    state.ray.origin = hit.point;
    state.contacts = hit.other_side;
    state.nesting = hit.nesting_after;
    found = {};
    Query query{{}, &state, &found};
    init(query.context);
    trace_single(scene, query);
  }
  return std::nullopt;
}

World::World(const std::vector<PlacedShape>& shapes, double farthest_coordinate)
    : impl_(std::make_unique<Impl>(shapes, farthest_coordinate)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

std::optional<Hit> World::closest(const RayState& state) const {
  NearestCandidates found;
  Query query{{}, &state, &found};
  init(query.context);
  trace_single(impl_->scene, query);
  return impl_->finish(state, found);
}

void World::closest(std::span<const RayState> states, std::span<std::optional<Hit>> hits,
                    Tracing tracing) const {
  for (std::size_t begin = 0; begin < states.size(); begin += kWidest) {
    const std::size_t count = std::min(kWidest, states.size() - begin);
    if (tracing == Tracing::single || count == 1) {
      for (std::size_t i = begin; i < begin + count; ++i)
        hits[i] = closest(states[i]);
      continue;
    }
    std::array<NearestCandidates, kWidest> found;
    Query query{{}, &states[begin], found.data()};
    init(query.context);
    if (count <= 4)
      trace_packet<RTCRayHit4, 4>(impl_->scene, query, count);
    else if (count <= 8)
      trace_packet<RTCRayHit8, 8>(impl_->scene, query, count);
    else
      trace_packet<RTCRayHit16, 16>(impl_->scene, query, count);
    for (std::size_t i = 0; i < count; ++i)
      hits[begin + i] = impl_->finish(states[begin + i], found[i]);
  }
}

bool World::occluded(const RayState& state, double distance) const {
  Query query{{}, &state, nullptr, distance};
  init(query.context);
  RTCRay ray;
  set_ray(ray, 0, state.ray, rounded_up(distance));
  occluded_one(impl_->scene, query.context, ray);
  return ray.tfar < 0.0f;
}

Nesting World::nesting_at(const dvec3& point) const {
  Nesting nesting;
  for (std::size_t i = 0; i < impl_->shapes.size() && !nesting.full(); ++i)
    if (contains(impl_->shapes[i], point)) nesting.push_back({static_cast<std::int32_t>(i)});
  return nesting;
}

MediumId World::medium_of(const Nesting& nesting) const {
  return abbe::medium_of(impl_->shapes, nesting);
}

const std::vector<PlacedShape>& World::shapes() const {
  return impl_->shapes;
}

std::string embree_version() {
  return RTC_VERSION_STRING;
}

} // namespace abbe
