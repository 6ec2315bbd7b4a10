#pragma once

#include "core/bundles/bundle.h"
#include "core/plan/plan.h"
#include "geometry/world/world.h"
#include "spectral/fraunhofer.h"

#include <optional>

namespace abbe {

/// The wavelength of the d line, by which glasses are known: the one ray that looks through glass
/// for the layers that tell of it has this.
inline constexpr double kSeenThroughNm = kLineD_nm;

/// What a camera ray meets that goes on by mirrors and glass.
struct SeenThrough {
  std::optional<Hit> end;    ///< what it ends on; nothing where it leaves the scene
  double distance = 0.0;     ///< how far it went to there, in scene units
  double deviation = 0.0;    ///< the angle between its first and its last direction, in radians
  int surfaces = 0;          ///< how many have turned it; panes have not
  double glass_length = 0.0; ///< how far it went through media other than air, in scene units
  int total_reflections = 0; ///< how many surfaces of glass have let nothing through
  dvec3 direction{0.0};      ///< the last one
};

/// Follows a camera ray from what it meets. At a surface that lets light through the ray is
/// refracted, or reflected under total reflection; at one that only mirrors it is reflected; at all
/// others, and behind many surfaces, it ends. Of a mixture the larger part counts.
[[nodiscard]] SeenThrough see_through(const Plan& plan, const World& world, RayState state,
                                      const Hit& first, double nm = kSeenThroughNm);

} // namespace abbe
