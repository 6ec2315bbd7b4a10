#pragma once

#include "geometry/ray.h"

namespace abbe {

/// A ray in a shape's own frame. `coordinate_error` bounds the rounding error of its origin and of
/// the shape's own coordinates there; solvers turn it into the error of the t they return.
struct LocalRay {
  dvec3 origin{0.0};
  dvec3 direction{0.0, 0.0, 1.0};
  double coordinate_error = 0.0;

  [[nodiscard]] dvec3 at(double t) const { return origin + t * direction; }
};

} // namespace abbe
