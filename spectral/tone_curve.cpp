#include "spectral/tone_curve.h"

#include <cmath>

namespace abbe {
namespace {

// Hable's constants: shoulder strength, linear strength and angle, toe strength, numerator and
// denominator; then the luminance that is white, and what luminances are multiplied by. [Hab10]
constexpr double kA = 0.15, kB = 0.50, kC = 0.10, kD = 0.20, kE = 0.02, kF = 0.30;
constexpr double kWhite = 11.2, kGain = 2.0;

constexpr double hable(double x) {
  return (x * (kA * x + kC * kB) + kD * kE) / (x * (kA * x + kB) + kD * kF) - kE / kF;
}

/// The derivative of `hable` at 0.
constexpr double kSlopeAtBlack = (kC * kB * kD * kF - kD * kE * kB) / (kD * kF * kD * kF);

double filmic(double luminance) {
  const double x = kGain * luminance;
  if (x <= 0.0) return kSlopeAtBlack * x / hable(kWhite);
  return x < kWhite ? hable(x) / hable(kWhite) : 1.0;
}

} // namespace

double tone(ToneCurve curve, double luminance) {
  switch (curve) {
  case ToneCurve::linear:
    return luminance;
  case ToneCurve::filmic:
    return filmic(luminance);
  }
  return luminance;
}

LinearRgb with_tone(const LinearRgb& c, ToneCurve curve, const Vector3& weights) {
  if (curve == ToneCurve::linear) return c;
  const double luminance = weights[0] * c.r + weights[1] * c.g + weights[2] * c.b;
  // A colour without luminance takes the limit of the factor.
  const double factor =
      luminance != 0.0 ? tone(curve, luminance) / luminance : kGain * kSlopeAtBlack / hable(kWhite);
  return {factor * c.r, factor * c.g, factor * c.b};
}

} // namespace abbe
