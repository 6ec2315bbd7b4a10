#include "spectral/color_difference.h"

#include <cmath>
#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

// The cube root, continued below (6/29)^3 by its tangent so that black has L* = 0.
double lightness_curve(double ratio) {
  constexpr double kDelta = 6.0 / 29.0;
  return ratio > kDelta * kDelta * kDelta ? std::cbrt(ratio)
                                          : ratio / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

double pow7(double x) {
  return x * x * x * x * x * x * x;
}

// Weight that is 0 for greys and 1 for vivid colours; 25 is the turning point in chroma.
double chroma_weight(double chroma) {
  return std::sqrt(pow7(chroma) / (pow7(chroma) + pow7(25.0)));
}

// Hue in 0..2 pi. That of a grey does not matter: differences in hue are weighted with chroma.
double hue_angle(double a, double b) {
  const double angle = std::atan2(b, a);
  return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

// Difference and mean of two hues along the shorter arc.
struct HuePair {
  double difference;
  double mean;
};

HuePair pair_hues(double h1, double h2) {
  const double d = h2 - h1;
  const double sum = h1 + h2;
  if (std::abs(d) <= kPi) return {d, sum / 2.0};
  const double difference = d > 0.0 ? d - 2.0 * kPi : d + 2.0 * kPi;
  return {difference, (sum < 2.0 * kPi ? sum + 2.0 * kPi : sum - 2.0 * kPi) / 2.0};
}

double radians(double angle_deg) {
  return angle_deg * kPi / 180.0;
}

} // namespace

Lab to_lab(const Xyz& color, const Xyz& white) {
  const double fx = lightness_curve(color.x / white.x);
  const double fy = lightness_curve(color.y / white.y);
  const double fz = lightness_curve(color.z / white.z);
  return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

double delta_e_2000(const Lab& first, const Lab& second) {
  // The a* axis is stretched for greys; primes mark values after it, as in [SWD05].
  const double mean_chroma = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2.0;
  const double stretch = 1.0 + 0.5 * (1.0 - chroma_weight(mean_chroma));
  const double a1 = stretch * first.a;
  const double a2 = stretch * second.a;
  const double c1 = std::hypot(a1, first.b);
  const double c2 = std::hypot(a2, second.b);
  const HuePair hue = pair_hues(hue_angle(a1, first.b), hue_angle(a2, second.b));

  const double delta_l = second.l - first.l;
  const double delta_c = c2 - c1;
  const double delta_h = 2.0 * std::sqrt(c1 * c2) * std::sin(hue.difference / 2.0);

  const double mean_c = (c1 + c2) / 2.0;
  const double t = 1.0 - 0.17 * std::cos(hue.mean - radians(30.0)) +
                   0.24 * std::cos(2.0 * hue.mean) +
                   0.32 * std::cos(3.0 * hue.mean + radians(6.0)) -
                   0.20 * std::cos(4.0 * hue.mean - radians(63.0));
  const double l50 = ((first.l + second.l) / 2.0 - 50.0) * ((first.l + second.l) / 2.0 - 50.0);
  const double sl = 1.0 + 0.015 * l50 / std::sqrt(20.0 + l50);
  const double sc = 1.0 + 0.045 * mean_c;
  const double sh = 1.0 + 0.015 * mean_c * t;

  // Chroma and hue interact in the blues, around 275 degrees.
  const double blue = (hue.mean - radians(275.0)) / radians(25.0);
  const double rotation =
      -2.0 * chroma_weight(mean_c) * std::sin(radians(60.0) * std::exp(-blue * blue));

  const double l = delta_l / sl;
  const double c = delta_c / sc;
  const double h = delta_h / sh;
  return std::sqrt(l * l + c * c + h * h + rotation * c * h);
}

} // namespace abbe
