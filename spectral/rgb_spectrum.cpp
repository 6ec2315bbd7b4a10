#include "spectral/rgb_spectrum.h"

#include "spectral/band_grid.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

// A reflectance is S(x) = 1/2 + x / (2 sqrt(1 + x^2)) of a quadratic x(t) = a t^2 + b t + c, with t
// from -1 at 380 nm to 1 at 780 nm [JH19]. The three coefficients are found so that the spectrum,
// seen at 81 bands under D65, has the wanted linear sRGB.

double position(int sample) {
  return (sample - 40) / 40.0;
}

double quadratic(const Vector3& c, double t) {
  return (c[0] * t + c[1]) * t + c[2];
}

double sigmoid(double x) {
  return 0.5 + x / (2.0 * std::sqrt(1.0 + x * x));
}

double sigmoid_slope(double x) {
  return 0.5 / ((1.0 + x * x) * std::sqrt(1.0 + x * x));
}

double sigmoid_inverse(double s) {
  return (s - 0.5) / std::sqrt(s * (1.0 - s));
}

const Curve& d65() {
  static const Curve curve = *find_illuminant("D65");
  return curve;
}

// Per sample, what it adds to linear sRGB under D65, relative to the perfect reflector: each
// component sums to 1 over the samples, so a flat spectrum is a grey exactly.
std::vector<Vector3> load_rgb_weights() {
  std::vector<Vector3> weights;
  Vector3 white{};
  for (const Xyz& xyz : band_weights(BandGrid(kSampleCount), d65())) {
    const LinearRgb rgb = to_linear_srgb(xyz);
    weights.push_back({rgb.r, rgb.g, rgb.b});
    for (int i = 0; i < 3; ++i)
      white[i] += weights.back()[i];
  }
  for (Vector3& weight : weights)
    for (int i = 0; i < 3; ++i)
      weight[i] /= white[i];
  return weights;
}

const std::vector<Vector3>& rgb_weights() {
  static const std::vector<Vector3> weights = load_rgb_weights();
  return weights;
}

// Difference of the spectrum's colour from the target, and its derivatives by the coefficients.
struct Residual {
  Vector3 value{};
  Matrix3 jacobian{};

  double squared() const { return value[0] * value[0] + value[1] * value[1] + value[2] * value[2]; }
};

Residual evaluate(const Vector3& coefficients, const Vector3& target) {
  Residual result;
  for (int k = 0; k < kSampleCount; ++k) {
    const double t = position(k);
    const double x = quadratic(coefficients, t);
    const double s = sigmoid(x);
    const double slope = sigmoid_slope(x);
    const Vector3& weight = rgb_weights()[k];
    for (int i = 0; i < 3; ++i) {
      result.value[i] += weight[i] * s;
      result.jacobian[i][0] += weight[i] * slope * t * t;
      result.jacobian[i][1] += weight[i] * slope * t;
      result.jacobian[i][2] += weight[i] * slope;
    }
  }
  for (int i = 0; i < 3; ++i)
    result.value[i] -= target[i];
  return result;
}

// The step of Levenberg and Marquardt: (J'J + damping diag(J'J)) step = -J'r [Mar63].
Vector3 damped_step(const Residual& r, double damping) {
  Matrix3 normal{};
  Vector3 gradient{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      gradient[j] -= r.jacobian[i][j] * r.value[i];
      for (int k = 0; k < 3; ++k)
        normal[j][k] += r.jacobian[i][j] * r.jacobian[i][k];
    }
  for (int i = 0; i < 3; ++i)
    normal[i][i] += damping * normal[i][i];
  return multiply(inverse(normal), gradient);
}

constexpr double kGoodEnough = 1e-24; // of the squared error in linear sRGB
constexpr double kGoodForPictures = 1e-14;

Vector3 solve(Vector3 coefficients, const Vector3& target, double good_enough) {
  constexpr int kMaxSteps = 1000; // tens, but hundreds for a nearly black pure red
  double damping = 1e-3;
  Residual current = evaluate(coefficients, target);
  for (int i = 0; i < kMaxSteps && current.squared() > good_enough && damping < 1e12; ++i) {
    const Vector3 step = damped_step(current, damping);
    Vector3 trial = coefficients;
    for (int j = 0; j < 3; ++j)
      trial[j] += step[j];
    const Residual next = evaluate(trial, target);
    if (next.squared() < current.squared()) {
      coefficients = trial;
      current = next;
      damping *= 0.2;
    } else {
      damping *= 5.0;
    }
  }
  return coefficients;
}

LinearRgb clamped(const LinearRgb& c) {
  return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
}

} // namespace

Curve rgb_reflectance(const LinearRgb& color) {
  const auto [r, g, b] = clamped(color);
  if (r == g && g == b) return Curve::constant(r);
  // From the flat spectrum of equal luminance, kept off 0 and 1, where the sigmoid never gets.
  const double grey = std::clamp(luminance({r, g, b}), 1e-12, 1.0 - 1e-12);
  const Vector3 start{0.0, 0.0, sigmoid_inverse(grey)};
  const Vector3 coefficients = solve(start, {r, g, b}, kGoodEnough);
  std::vector<double> values(kSampleCount);
  for (int k = 0; k < kSampleCount; ++k)
    values[k] = sigmoid(quadratic(coefficients, position(k)));
  return Curve::samples81(std::move(values));
}

double SmoothCurve::at(double lambda_nm) const {
  return scale * sigmoid(quadratic(coefficients, position(lambda_nm)));
}

SmoothCurve smooth_emission(const LinearRgb& color) {
  const Vector3 c{std::max(color.r, 0.0), std::max(color.g, 0.0), std::max(color.b, 0.0)};
  const double scale = 2.0 * std::max({c[0], c[1], c[2]});
  if (c[0] == c[1] && c[1] == c[2]) return {{}, scale}; // half of it everywhere
  const Vector3 target{c[0] / scale, c[1] / scale, c[2] / scale};
  const double grey = luminance({target[0], target[1], target[2]});
  return {solve({0.0, 0.0, sigmoid_inverse(grey)}, target, kGoodForPictures), scale};
}

Curve rgb_emission(const LinearRgb& color) {
  const double peak = std::max({color.r, color.g, color.b, 0.0});
  if (peak == 0.0) return Curve::constant(0.0);
  // Twice the peak keeps the reflectance at or below about 1/2, where it is smoothest [JH19].
  const double scale = 2.0 * peak;
  const Curve shape = rgb_reflectance({color.r / scale, color.g / scale, color.b / scale});
  return d65().times(shape).scaled(scale);
}

} // namespace abbe
