#include "geometry/world/world_callbacks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace abbe {
namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

/// True when a ray does not run to the side of a contact on which it should be.
template <class S>
bool contradicts(const S& shape, const LocalRay& ray, const SurfaceContact& contact) {
  const double outwards = glm::dot(outward_normal(shape, ray.origin, contact.face), ray.direction);
  return contact.side == Side::outside ? outwards < 0.0 : outwards > 0.0;
}

/// The ray in the frame of the shape, with its bounds of error. A tree's leaves are placed in the
/// world already.
template <class S>
LocalRay ray_for(const Primitive& primitive, const Ray& ray) {
  if constexpr (std::is_same_v<S, CsgTree>)
    return {ray.origin, ray.direction};
  else
    return primitive.frame.see(ray).with_errors();
}

const SurfaceContact* contact_with(ShapeId id, const Contacts& contacts) {
  for (const SurfaceContact& contact : contacts)
    if (contact.shape == id) return &contact;
  return nullptr;
}

/// A ray may cross a convex solid once, and a flat shape: their first contact says all.
template <class S>
constexpr bool kCrossedOften = std::is_same_v<S, CsgTree> || std::is_same_v<S, Mesh>;

/// What a ray meets next of a shape of which it has crossed faces where it is.
template <class S>
[[gnu::noinline]] bool find_behind_crossed(const Query& query, const Primitive& primitive,
                                           const RayState& state, ShapeState known,
                                           ShapeCrossing& found) {
  ShortVector<TouchedFace, 8> crossed;
  for (const SurfaceContact& contact : query.passage->crossed())
    if (contact.shape == primitive.id)
      crossed.push_back({contact.face, contact.side == Side::inside});
  known.others = {crossed.begin(), crossed.size()};
  const auto next = next_crossing(*std::get_if<S>(&primitive.placed->shape),
                                  ray_for<S>(primitive, state.ray), known);
  if (next) found = *next;
  return next.has_value();
}

/// What a ray of the query meets next of a shape; it need not be found at the query's distance or
/// beyond.
template <class S>
bool find_crossing(const Query& query, const Primitive& primitive, const RayState& state,
                   ShapeCrossing& found) {
  const S& shape = *std::get_if<S>(&primitive.placed->shape);
  ShapeState known;
  if constexpr (!FlatShape<S>)
    known.inside =
        std::find(state.nesting.begin(), state.nesting.end(), primitive.id) != state.nesting.end();
  if (const SurfaceContact* contact = contact_with(primitive.id, state.contacts)) {
    const bool outside = contact->side == Side::outside;
    const bool first = contact == state.contacts.begin();
    if (!first && contradicts(shape, ray_for<S>(primitive, state.ray), *contact)) {
      found.set(0.0, 0.0, contact->face, outside);
      return true;
    }
    known = {!outside, true, contact->face};
  }
  if constexpr (kCrossedOften<S>)
    if (query.passage && !query.passage->crossed().empty()) [[unlikely]]
      return find_behind_crossed<S>(query, primitive, state, known, found);
  if constexpr (FlatShape<S> || PlaneFaced<S> || std::is_same_v<S, Sphere>) {
    return find_next(shape, primitive.frame.see(state.ray), known, query.distance, found);
  } else {
    const auto next = next_crossing(shape, ray_for<S>(primitive, state.ray), known);
    if (next) found = *next;
    return next.has_value();
  }
}

bool surely_nearer(const ShapeCrossing& crossing, double distance) {
  return crossing.t + crossing.t_error < distance;
}

template <class S>
void intersect_callback(const RTCIntersectFunctionNArguments* args) noexcept {
  [[maybe_unused]] const FloatTraps on(true);
  const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
  const auto& query = *reinterpret_cast<const Query*>(args->context);
  const Primitive& primitive = group.primitives[args->primID];
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const unsigned ray = RTCRayN_id(rays, args->N, i);
    ShapeCrossing found;
    if (!find_crossing<S>(query, primitive, query.states[ray], found)) continue;
    if (!surely_nearer(found, query.distance)) continue;
    if (!query.found[ray].offer(primitive.id, found)) continue;
    float& tfar = RTCRayN_tfar(rays, args->N, i);
    tfar = std::min(tfar, rounded_up(query.found[ray].reach()));
  }
}

template <class S>
void occluded_callback(const RTCOccludedFunctionNArguments* args) noexcept {
  [[maybe_unused]] const FloatTraps on(true);
  const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
  auto& query = *reinterpret_cast<Query*>(args->context);
  const Primitive& primitive = group.primitives[args->primID];
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const RayState& state = query.states[RTCRayN_id(args->ray, args->N, i)];
    ShapeCrossing found;
    if (!find_crossing<S>(query, primitive, state, found)) continue;
    if (!surely_nearer(found, query.distance)) continue;
    if (query.glass_may_hide && primitive.glass)
      query.met_glass = true;
    else
      RTCRayN_tfar(args->ray, args->N, i) = -kFloatInfinity;
  }
}

void bounds_callback(const RTCBoundsFunctionArguments* args) noexcept {
  const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
  const Bounds box = bounds(*group.primitives[args->primID].placed).grown(group.padding);
  const auto down = [](double v) { return std::nextafter(static_cast<float>(v), -kFloatInfinity); };
  const auto up = [](double v) { return std::nextafter(static_cast<float>(v), kFloatInfinity); };
  RTCBounds& out = *args->bounds_o;
  out.lower_x = down(box.lower.x);
  out.lower_y = down(box.lower.y);
  out.lower_z = down(box.lower.z);
  out.upper_x = up(box.upper.x);
  out.upper_y = up(box.upper.y);
  out.upper_z = up(box.upper.z);
}

template <std::size_t Type>
void attach_type(const ShapeGroups& groups, RTCDevice device, RTCScene scene) {
  using S = std::variant_alternative_t<Type, Shape>;
  const ShapeGroup& group = groups[Type];
  if (group.primitives.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(group.primitives.size()));
  rtcSetGeometryUserData(geometry, const_cast<ShapeGroup*>(&group)); // read only, above
  rtcSetGeometryBoundsFunction(geometry, bounds_callback, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_callback<S>);
  rtcSetGeometryOccludedFunction(geometry, occluded_callback<S>);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

} // namespace

void attach(const ShapeGroups& groups, RTCDevice device, RTCScene scene) {
  [&]<std::size_t... Type>(std::index_sequence<Type...>) {
    (attach_type<Type>(groups, device, scene), ...);
  }(std::make_index_sequence<std::variant_size_v<Shape>>());
}

} // namespace abbe
