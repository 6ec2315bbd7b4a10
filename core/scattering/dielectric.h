#pragma once

#include "core/optics/transport.h"
#include "core/plan/plan.h"

namespace abbe {

/// What a boundary between two media does with a ray, per band, at one angle.
struct DielectricScatter {
  std::vector<float> reflected;   ///< factor on radiance that comes by reflection
  std::vector<float> transmitted; ///< factor on radiance that comes through; 0 under TIR
};

/// Fills [first, last) of `scatter`. `n_before` and `n_after` are indices per band on the side of
/// the camera and behind the boundary. Radiance that comes through is scaled by
/// (n_before / n_after)^2, since a pencil of rays changes its solid angle there; flux is not.
void scatter_dielectric(const MaterialPlan& material, double cos_i, const double* n_before,
                        const double* n_after, int first, int last, DielectricScatter& scatter,
                        Transport transport = Transport::radiance);

/// The transmittance of a boundary for the thesis's attenuated shadow ray, which goes straight on;
/// multiplied into [first, last) of `transmittance`. The angle is taken in the thinner medium, so
/// that total reflection, which a bent ray would have avoided, does not occur.
void attenuate_straight(const MaterialPlan& material, double cos_i, const double* n_before,
                        const double* n_after, int first, int last, float* transmittance);

} // namespace abbe
