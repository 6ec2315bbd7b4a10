#pragma once

#include "spectral/dispersion.h"

#include <numbers>

namespace abbe {

/// The mean angular radius of the sun's disc, 16 minutes of arc [Cox00].
inline constexpr double kSunRadius = 0.2665 * std::numbers::pi / 180.0;

/// Spherical drops in the air, far smaller than a pixel and too many to be drawn one by one. Light
/// is scattered by the ray optics of a drop; see core/drops/drop_optics.h.
struct Drops {
  /// The area of the drops' discs per volume. A length leaves exp(-extinction * length) of the
  /// light unscattered.
  double extinction_per_mm = 0.0;
  Dispersion index = ConstantIndex{1.0}; ///< of the drops, relative to the air around them
  double sun_radius = kSunRadius;        ///< of the disc that parallel light comes from; 0: a point

  friend bool operator==(const Drops&, const Drops&) = default;
};

} // namespace abbe
