#include "spectral/tabulated_index.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace abbe {
namespace {

double sign(double x) {
  return x > 0.0 ? 1.0 : (x < 0.0 ? -1.0 : 0.0);
}

/// Steffen's slope at a point between the secants s0 and s1 of the steps h0 and h1: that of the
/// parabola through the three points, limited so that neither side overshoots.
double inner_slope(double s0, double s1, double h0, double h1) {
  const double parabola = (s0 * h1 + s1 * h0) / (h0 + h1);
  return (sign(s0) + sign(s1)) * std::min({std::abs(s0), std::abs(s1), 0.5 * std::abs(parabola)});
}

/// The slope at an end whose own secant is s0, the next one s1.
double end_slope(double s0, double s1, double h0, double h1) {
  const double ratio = h0 / (h0 + h1);
  const double parabola = s0 * (1.0 + ratio) - s1 * ratio;
  if (parabola * s0 <= 0.0) return 0.0;
  return std::abs(parabola) > 2.0 * std::abs(s0) ? 2.0 * s0 : parabola;
}

std::vector<double> steffen_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t last = x.size() - 1;
  std::vector<double> slopes(x.size(), 0.0);
  if (last == 0) return slopes;
  std::vector<double> step(last), secant(last);
  for (std::size_t i = 0; i < last; ++i) {
    step[i] = x[i + 1] - x[i];
    secant[i] = (y[i + 1] - y[i]) / step[i];
  }
  if (last == 1) return {secant[0], secant[0]};
  for (std::size_t i = 1; i < last; ++i)
    slopes[i] = inner_slope(secant[i - 1], secant[i], step[i - 1], step[i]);
  slopes.front() = end_slope(secant[0], secant[1], step[0], step[1]);
  slopes.back() = end_slope(secant[last - 1], secant[last - 2], step[last - 1], step[last - 2]);
  return slopes;
}

} // namespace

TabulatedIndex tabulated_index(std::vector<double> wavelengths_nm, std::vector<double> n) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (wavelengths_nm.empty() || wavelengths_nm.size() != n.size())
    throw std::invalid_argument("a table of n needs one index per wavelength");
  if (!std::all_of(wavelengths_nm.begin(), wavelengths_nm.end(), finite) ||
      !std::all_of(n.begin(), n.end(), finite))
    throw std::invalid_argument("a table of n has a number that is not finite");
  if (std::adjacent_find(wavelengths_nm.begin(), wavelengths_nm.end(), std::greater_equal<>()) !=
      wavelengths_nm.end())
    throw std::invalid_argument("the wavelengths of a table of n must ascend");
  std::vector<double> slopes = steffen_slopes(wavelengths_nm, n);
  return {std::move(wavelengths_nm), std::move(n), std::move(slopes)};
}

double refractive_index(const TabulatedIndex& law, double lambda_nm) {
  const std::vector<double>& x = law.wavelengths_nm;
  if (lambda_nm <= x.front()) return law.n.front();
  if (lambda_nm >= x.back()) return law.n.back();
  const auto above = std::upper_bound(x.begin(), x.end(), lambda_nm);
  const auto i = static_cast<std::size_t>(above - x.begin()) - 1;
  const double h = x[i + 1] - x[i];
  const double t = (lambda_nm - x[i]) / h;
  const double u = 1.0 - t;
  // Hermite's cubic through both points with their slopes.
  return u * u * ((1.0 + 2.0 * t) * law.n[i] + t * h * law.slopes[i]) +
         t * t * ((1.0 + 2.0 * u) * law.n[i + 1] - u * h * law.slopes[i + 1]);
}

bool is_achromatic(const TabulatedIndex& law) {
  return std::all_of(law.n.begin(), law.n.end(), [&](double n) { return n == law.n.front(); });
}

} // namespace abbe
