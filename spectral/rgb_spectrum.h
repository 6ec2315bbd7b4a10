#pragma once

#include "spectral/color.h"
#include "spectral/curve.h"

#include <array>

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

/// The curve `scale` S(a t^2 + b t + c), with S(x) = 1/2 + x / (2 sqrt(1 + x^2)) and t from -1 at
/// 380 nm to 1 at 780 nm [JH19]: three numbers where many colours must be kept.
struct SmoothCurve {
  std::array<double, 3> coefficients{}; ///< a, b, c
  double scale = 0.0;

  [[nodiscard]] double at(double lambda_nm) const;
  /// t.
  [[nodiscard]] static double position(double lambda_nm) { return (lambda_nm - 580.0) / 200.0; }
};

/// The curve that makes D65 an emission of this colour, as `rgb_emission` does, to 1e-7 of its
/// largest component. It is solved when called; SmoothEmissions is for many.
[[nodiscard]] SmoothCurve smooth_emission(const LinearRgb& color);

} // namespace abbe
