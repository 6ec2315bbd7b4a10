#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Fills [first, last) of `reflected` with the factors on radiance that comes by reflection.
/// `n_before` are indices per band on the side of the camera.
void reflect_conductor(const MaterialPlan& material, double cos_i, const double* n_before,
                       int first, int last, float* reflected);

} // namespace abbe
