#pragma once

// Embree, for world*.cpp alone. Its two interfaces (3 in Debian 12, 4 in Debian 13) are told apart
// here and nowhere else.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "geometry/rays/float_traps.h"

#include <memory>
#include <type_traits>

namespace abbe::embree {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

#if RTC_VERSION_MAJOR >= 4

using Context = RTCRayQueryContext;
inline void init(Context& context) {
  rtcInitRayQueryContext(&context);
}
inline RTCIntersectArguments arguments(Context& context, RTCRayQueryFlags flags) {
  RTCIntersectArguments found;
  rtcInitIntersectArguments(&found);
  found.context = &context;
  found.flags = flags;
  return found;
}
inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray) {
  [[maybe_unused]] const FloatTraps off(false);
  auto args = arguments(context, RTC_RAY_QUERY_FLAG_INCOHERENT);
  rtcIntersect1(scene, &ray, &args);
}
inline void intersect(const int* valid, RTCScene scene, Context& context, RTCRayHit4& rays) {
  [[maybe_unused]] const FloatTraps off(false);
  auto args = arguments(context, RTC_RAY_QUERY_FLAG_COHERENT);
  rtcIntersect4(valid, scene, &rays, &args);
}
inline void intersect(const int* valid, RTCScene scene, Context& context, RTCRayHit8& rays) {
  [[maybe_unused]] const FloatTraps off(false);
  auto args = arguments(context, RTC_RAY_QUERY_FLAG_COHERENT);
  rtcIntersect8(valid, scene, &rays, &args);
}
inline void intersect(const int* valid, RTCScene scene, Context& context, RTCRayHit16& rays) {
  [[maybe_unused]] const FloatTraps off(false);
  auto args = arguments(context, RTC_RAY_QUERY_FLAG_COHERENT);
  rtcIntersect16(valid, scene, &rays, &args);
}
inline void occluded(RTCScene scene, Context& context, RTCRay& ray) {
  [[maybe_unused]] const FloatTraps off(false);
  RTCOccludedArguments args;
  rtcInitOccludedArguments(&args);
  args.context = &context;
  rtcOccluded1(scene, &ray, &args);
}

#else

using Context = RTCIntersectContext;
inline void init(Context& context) {
  rtcInitIntersectContext(&context);
}
inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray) {
  [[maybe_unused]] const FloatTraps off(false);
  rtcIntersect1(scene, &context, &ray);
}
inline void intersect(const int* valid, RTCScene scene, Context& context, RTCRayHit4& rays) {
  [[maybe_unused]] const FloatTraps off(false);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect4(valid, scene, &context, &rays);
}
inline void intersect(const int* valid, RTCScene scene, Context& context, RTCRayHit8& rays) {
  [[maybe_unused]] const FloatTraps off(false);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &context, &rays);
}
inline void intersect(const int* valid, RTCScene scene, Context& context, RTCRayHit16& rays) {
  [[maybe_unused]] const FloatTraps off(false);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &context, &rays);
}
inline void occluded(RTCScene scene, Context& context, RTCRay& ray) {
  [[maybe_unused]] const FloatTraps off(false);
  rtcOccluded1(scene, &context, &ray);
}

#endif

} // namespace abbe::embree
