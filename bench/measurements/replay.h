#pragma once

#include "core/bundles/ray_record.h"
#include "geometry/world/world.h"

#include <array>

namespace abbe::bench {

inline constexpr std::array kRayKinds{RayKind::camera,    RayKind::reflected, RayKind::refracted,
                                      RayKind::scattered, RayKind::shadow,    RayKind::light};
inline constexpr std::array kPacketWidths{1, 4, 8, 16};

[[nodiscard]] const char* name(RayKind kind);

/// Recorded rays of one kind, in the order in which they were traced.
struct RaysOfKind {
  RayKind kind = RayKind::camera;
  std::vector<RayState> states;
  std::vector<double> distances;
  bool any_hit = false;
};

/// The record sorted by kind; kinds without rays are left out.
[[nodiscard]] std::vector<RaysOfKind> by_kind(const RayRecord& record);

/// Runs the rays through raw Embree, `width` at a time, on this many threads; returns how many met
/// something. Rays that ask only for any hit go one at a time, whatever the width.
std::size_t replay(const World& world, const RaysOfKind& rays, int width, int threads);

/// The same through the world's ordinary queries: Embree, and the work that turns candidates into
/// hits. Kinds that the renderer hands over in packets go 16 at a time, the others one by one.
std::size_t query(const World& world, const RaysOfKind& rays, int threads);

} // namespace abbe::bench
