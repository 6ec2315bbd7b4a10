#pragma once

#include "core/scene/material.h"
#include "core/scene/texture.h"

#include <span>
#include <string>

namespace abbe {

/// How much of the light that a surface gets it may give back, at most.
struct MaterialEnergy {
  double most = 0.0; ///< of the light of one wavelength, as a share
  double at_nm = 0.0;
  double diffuse = 0.0, highlight = 0.0, specular = 0.0; ///< the parts there
};

/// The sum of a material's parts where it is largest. Reflectivity and transparency scale shares
/// that add up to 1, unless `fresnel` is off. What a coat reflects is not counted, since less goes
/// to the part below it. Mixtures are not asked: each of their materials is by itself.
[[nodiscard]] MaterialEnergy most_given_back(const Material& material,
                                             std::span<const ReflectanceImage> images);

/// Shares that stand by themselves, without `fresnel`, are lowered in proportion where they add up
/// to more than 1. Returns their largest sum before.
double limit_shares(Material& material);

} // namespace abbe
