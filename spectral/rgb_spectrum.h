#pragma once

#include "spectral/color.h"
#include "spectral/curve.h"

namespace abbe {

/// A smooth reflectance between 0 and 1 whose colour under D65 is `color`, relative to the perfect
/// reflector: (1, 1, 1) and other greys are exact constants. Components are clamped to 0..1 first.
/// It is a sigmoid of a quadratic in wavelength [JH19], solved when called, in about 10 us.
/// All of the cube, its faces and corners included, is met to 1e-11 per component; the price at a
/// corner is a spectrum with steps between 0 and 1, which only there is not smooth.
[[nodiscard]] Curve rgb_reflectance(const LinearRgb& color);

/// A smooth emission whose colour is `color`, relative to D65 as white: (1, 1, 1) is D65 with Y
/// = 1. Components may exceed 1; negative ones count as 0. It is s D65 rgb_reflectance(color / s)
/// with s twice the largest component, and so scales with the colour.
///
/// The white of both functions is D65 at the 81 samples. Its x, y are 2e-5, 3e-5 from the rounded
/// 0.3127, 0.3290 that define sRGB, so to_linear_srgb gives 1.00004 1.00001 0.99973 for it.
[[nodiscard]] Curve rgb_emission(const LinearRgb& color);

} // namespace abbe
