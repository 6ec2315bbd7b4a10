#include "spectral/fit_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace abbe {
namespace {

constexpr std::array kExponents{0, -2, -4, 2};

void require_points(const std::vector<double>& nm, const std::vector<double>& n) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0.0; };
  if (nm.empty() || nm.size() != n.size())
    throw std::invalid_argument("a fit of n needs one index per wavelength");
  if (!std::all_of(nm.begin(), nm.end(), positive) || !std::all_of(n.begin(), n.end(), positive))
    throw std::invalid_argument("a fit of n needs numbers above 0");
  if (std::adjacent_find(nm.begin(), nm.end(), std::greater_equal<>()) != nm.end())
    throw std::invalid_argument("the wavelengths of a fit of n must ascend");
}

using Column = std::vector<double>;

double dot(const Column& a, const Column& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

void subtract(Column& from, const Column& what, double factor) {
  for (std::size_t i = 0; i < from.size(); ++i)
    from[i] -= factor * what[i];
}

/// Least squares by Gram and Schmidt's method: makes the columns orthonormal one by one, takes
/// their share out of the right side, and solves the triangle that is left.
std::vector<double> least_squares(std::vector<Column> columns, Column right) {
  const std::size_t count = columns.size();
  std::vector<std::vector<double>> r(count, std::vector<double>(count, 0.0));
  std::vector<double> solution(count);
  for (std::size_t j = 0; j < count; ++j) {
    for (int pass = 0; pass < 2; ++pass) // the second pass takes out what rounding left
      for (std::size_t i = 0; i < j; ++i) {
        const double share = dot(columns[i], columns[j]);
        r[i][j] += share;
        subtract(columns[j], columns[i], share);
      }
    r[j][j] = std::sqrt(dot(columns[j], columns[j]));
    for (double& value : columns[j])
      value /= r[j][j];
    solution[j] = dot(columns[j], right);
    subtract(right, columns[j], solution[j]);
  }
  for (std::size_t j = count; j-- > 0;) {
    for (std::size_t i = j + 1; i < count; ++i)
      solution[j] -= r[j][i] * solution[i];
    solution[j] /= r[j][j];
  }
  return solution;
}

} // namespace

IndexFit fit_index(const std::vector<double>& wavelengths_nm, const std::vector<double>& n) {
  require_points(wavelengths_nm, n);
  const std::size_t terms = std::min(kExponents.size(), n.size());
  std::vector<Column> columns(terms);
  Column squares;
  for (std::size_t i = 0; i < n.size(); ++i) {
    const double um2 = wavelengths_nm[i] * wavelengths_nm[i] * 1e-6;
    const std::array row{1.0, 1.0 / um2, 1.0 / (um2 * um2), um2};
    for (std::size_t j = 0; j < terms; ++j)
      columns[j].push_back(row[j]);
    squares.push_back(n[i] * n[i]);
  }
  const std::vector<double> a = least_squares(std::move(columns), std::move(squares));
  IndexFit fit{{a[0], {}}, 0.0, wavelengths_nm.front()};
  for (std::size_t j = 1; j < terms; ++j)
    fit.law.terms.push_back({a[j], kExponents[j]});
  for (std::size_t i = 0; i < n.size(); ++i) {
    const double residual = std::abs(refractive_index(fit.law, wavelengths_nm[i]) - n[i]);
    if (residual <= fit.largest_residual) continue;
    fit.largest_residual = residual;
    fit.worst_nm = wavelengths_nm[i];
  }
  return fit;
}

} // namespace abbe
