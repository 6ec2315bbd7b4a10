#pragma once

#include "core/emitters/cone.h"

namespace abbe {

/// A disc of directions from which a light comes, the same from everywhere.
struct LightDisc {
  Cone directions;       ///< towards the light
  double radiance = 0.0; ///< per unit of the light's spectrum
};

} // namespace abbe
