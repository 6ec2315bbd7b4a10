#pragma once

#include "core/bundles/ray_record.h"
#include "geometry/rays/finite_ray.h"

#include <cstdint>
#include <span>

namespace abbe {

/// How many rays were traced, by kind, and what light paths left behind.
struct RayCounts {
  std::uint64_t camera = 0, reflected = 0, refracted = 0, scattered = 0, shadow = 0, light = 0;
  std::uint64_t splats = 0,
                photons = 0;    ///< what was added to the film, and kept for the photon map
  std::uint64_t not_finite = 0; ///< of the rays above: not traced, they meet nothing
  RayRecord* record = nullptr;  ///< keeps the rays themselves, where somebody wants to know them

  /// The number of all rays.
  [[nodiscard]] std::uint64_t total() const {
    return camera + reflected + refracted + scattered + shadow + light;
  }
  [[nodiscard]] std::uint64_t& of(RayKind kind) {
    switch (kind) {
    case RayKind::camera:
      return camera;
    case RayKind::reflected:
      return reflected;
    case RayKind::refracted:
      return refracted;
    case RayKind::scattered:
      return scattered;
    case RayKind::shadow:
      return shadow;
    case RayKind::light:
      break;
    }
    return light;
  }
  /// Counts rays that look for the nearest surface.
  void add(RayKind kind, std::span<const RayState> rays) {
    of(kind) += rays.size();
    for (const RayState& state : rays)
      not_finite += is_finite(state.ray) ? 0 : 1;
    if (!record) return;
    for (const RayState& ray : rays)
      record->add(kind, ray, kInfinity, false);
  }
  void add(RayKind kind, const RayState& ray) { add(kind, std::span(&ray, 1)); }
  /// Counts a ray that asks whether anything lies nearer than `distance`.
  void add_any_hit(RayKind kind, const RayState& ray, double distance) {
    ++of(kind);
    not_finite += is_finite(ray.ray) ? 0 : 1;
    if (record) record->add(kind, ray, distance, true);
  }
  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    reflected += other.reflected;
    refracted += other.refracted;
    scattered += other.scattered;
    shadow += other.shadow;
    light += other.light;
    splats += other.splats;
    photons += other.photons;
    not_finite += other.not_finite;
    return *this;
  }
};

} // namespace abbe
