#include "io/libraries/glass_formulas.h"

#include "spectral/band_grid.h"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace abbe {
namespace {

/// A point per nm of n as a function of the wavelength in um.
Dispersion tabulated(const std::function<double(double)>& n) {
  std::vector<double> nm, values;
  for (double at = std::floor(kLowerNm) - 5.0; at <= kUpperNm + 5.0; at += 1.0) {
    nm.push_back(at);
    values.push_back(n(1e-3 * at));
    if (!(values.back() > 0.0)) // tabulated_index refuses infinity
      throw std::invalid_argument("its index is no number above 0 in the visible range");
  }
  return tabulated_index(std::move(nm), std::move(values));
}

Dispersion checked(Dispersion law) {
  for (double nm = kLowerNm; nm <= kUpperNm; nm += 5.0)
    if (const double n = refractive_index(law, nm); !(n > 0.0 && std::isfinite(n)))
      throw std::invalid_argument("its index is no number above 0 in the visible range");
  return law;
}

/// n = a + b z + c z^2 + d L^2 + e L^4 + f L^6 with z = 1 / (L^2 - 0.028) (Herzberger).
double herzberger(const std::vector<double>& c, double um) {
  const double um2 = um * um, z = 1.0 / (um2 - 0.028);
  return c[0] + (c[1] + c[2] * z) * z + (c[3] + (c[4] + c[5] * um2) * um2) * um2;
}

Dispersion sellmeier(const std::vector<double>& c, std::size_t terms) {
  Sellmeier law;
  for (std::size_t i = 0; i < terms; ++i)
    if (c[2 * i] != 0.0) law.terms.push_back({c[2 * i], c[2 * i + 1]});
  return law;
}

Dispersion powers(const std::vector<double>& c, std::initializer_list<int> exponents) {
  PowerSeries law{c[0], {}};
  std::size_t i = 1;
  for (const int exponent : exponents)
    if (const double a = c[i++]; a != 0.0) law.terms.push_back({a, exponent});
  return law;
}

bool is_whole(double value) {
  return value == std::floor(value) && std::abs(value) < 100.0;
}

void require_pairs(std::span<const double> c) {
  if (c.size() % 2 == 0) throw std::invalid_argument("its coefficients are not one and then pairs");
}

/// c_1 + sum c_2i L^c_2i+1, from a place on.
double power_sum(std::span<const double> c, std::size_t first, double um) {
  double sum = 0.0;
  for (std::size_t i = first; i + 1 < c.size(); i += 2)
    sum += c[i] * std::pow(um, c[i + 1]);
  return sum;
}

/// n^2 = c_1 + c_2 L^c_3 / (L^2 - c_4^c_5) + the same of c_6 ... c_9 + c_10 L^c_11 + ...
double formula4(std::span<const double> c, double um) {
  double square = c[0] + power_sum(c, 9, um);
  for (std::size_t i = 1; i < 9 && i + 3 < c.size(); i += 4)
    if (c[i] != 0.0)
      square += c[i] * std::pow(um, c[i + 1]) / (um * um - std::pow(c[i + 2], c[i + 3]));
  return std::sqrt(square);
}

Dispersion read_sellmeier(std::span<const double> c, bool squared) {
  require_pairs(c);
  Sellmeier law{c[0], {}};
  for (std::size_t i = 1; i + 1 < c.size(); i += 2)
    law.terms.push_back({c[i], squared ? c[i + 1] * c[i + 1] : c[i + 1]});
  return law;
}

Dispersion read_power_series(const std::vector<double>& c) {
  require_pairs(c);
  PowerSeries law{c[0], {}};
  for (std::size_t i = 1; i + 1 < c.size(); i += 2) {
    if (!is_whole(c[i + 1]))
      return tabulated([&c](double um) { return std::sqrt(c[0] + power_sum(c, 1, um)); });
    law.terms.push_back({c[i], static_cast<int>(c[i + 1])});
  }
  return law;
}

Dispersion read_gas(std::span<const double> c) {
  require_pairs(c);
  GasFormula law{c[0], {}};
  for (std::size_t i = 1; i + 1 < c.size(); i += 2)
    law.terms.push_back({c[i], c[i + 1]});
  return law;
}

} // namespace

Dispersion agf_law(int formula, std::span<const double> coefficients) {
  std::vector<double> c(coefficients.begin(), coefficients.end());
  c.resize(std::max<std::size_t>(c.size(), 12), 0.0);
  switch (formula) {
  case 1: // Schott
    return checked(powers(c, {2, -2, -4, -6, -8}));
  case 2:
    return checked(sellmeier(c, 3));
  case 3:
    return tabulated([&c](double um) { return herzberger(c, um); });
  case 4: // n^2 - 1 = A + B L^2 / (L^2 - C^2) + D / (L^2 - E^2)
    return checked(Formula4{1.0 + c[0], {{c[1], 2, c[2] * c[2]}, {c[3], 0, c[4] * c[4]}}, {}});
  case 5: // Conrady
    return tabulated([&c](double um) { return c[0] + c[1] / um + c[2] / std::pow(um, 3.5); });
  case 6:
    return checked(sellmeier(c, 4));
  case 7: // n^2 = A + B / (L^2 - C) - D L^2
    return checked(Formula4{c[0], {{c[1], 0, c[2]}}, {{-c[3], 2}}});
  case 8: // n^2 = A + B L^2 / (L^2 - C) - D L^2
    return checked(Formula4{c[0], {{c[1], 2, c[2]}}, {{-c[3], 2}}});
  case 9: // n^2 = A + B L^2 / (L^2 - C) + D L^2 / (L^2 - E)
    return checked(Formula4{c[0], {{c[1], 2, c[2]}, {c[3], 2, c[4]}}, {}});
  case 10:
    return checked(powers(c, {2, -2, -4, -6, -8, -10, -12}));
  case 11:
    return checked(sellmeier(c, 5));
  case 12:
    return checked(powers(c, {2, -2, -4, -6, -8, 4, 6}));
  case 13:
    return checked(powers(c, {2, 4, -2, -4, -6, -8, -10, -12}));
  default:
    throw std::invalid_argument("there is no formula " + std::to_string(formula));
  }
}

Dispersion refractiveindex_law(int formula, std::span<const double> coefficients) {
  if (coefficients.empty()) throw std::invalid_argument("it has no coefficients");
  std::vector<double> c(coefficients.begin(), coefficients.end());
  switch (formula) {
  case 1:
    return checked(read_sellmeier(c, true));
  case 2:
    return checked(read_sellmeier(c, false));
  case 3:
    return checked(read_power_series(c));
  case 4:
    require_pairs(c);
    return tabulated([&c](double um) { return formula4(c, um); });
  case 5:
    require_pairs(c);
    return tabulated([&c](double um) { return c[0] + power_sum(c, 1, um); });
  case 6:
    return checked(read_gas(c));
  default:
    break;
  }
  c.resize(std::max<std::size_t>(c.size(), 6), 0.0);
  switch (formula) {
  case 7:
    return tabulated([&c](double um) { return herzberger(c, um); });
  case 8: // (n^2 - 1) / (n^2 + 2) = c_1 + c_2 L^2 / (L^2 - c_3) + c_4 L^2
    return tabulated([&c](double um) {
      const double um2 = um * um, part = c[0] + c[1] * um2 / (um2 - c[2]) + c[3] * um2;
      return std::sqrt((1.0 + 2.0 * part) / (1.0 - part));
    });
  case 9: // n^2 = c_1 + c_2 / (L^2 - c_3) + c_4 (L - c_5) / ((L - c_5)^2 + c_6)
    return tabulated([&c](double um) {
      const double off = um - c[4];
      return std::sqrt(c[0] + c[1] / (um * um - c[2]) + c[3] * off / (off * off + c[5]));
    });
  default:
    throw std::invalid_argument("there is no formula " + std::to_string(formula));
  }
}

} // namespace abbe
