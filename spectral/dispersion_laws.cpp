#include "spectral/dispersion_laws.h"

#include "spectral/square.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

// Quartz's range of n over the 405 nm of the renderer [War05].
constexpr double kThesisRange = 0.02204;
constexpr double kThesisSpan_nm = 405.0;
constexpr double kThesisFirst_nm = 380.0;

double micrometres(double lambda_nm) {
  return lambda_nm * 1e-3;
}

// x^exponent by multiplication: the same bits on every platform, unlike std::pow.
double power(double x, int exponent) {
  double result = 1.0;
  for (int i = 0; i < std::abs(exponent); ++i)
    result *= x;
  return exponent < 0 ? 1.0 / result : result;
}

double sum_powers(const std::vector<PowerTerm>& terms, double um) {
  double sum = 0.0;
  for (const PowerTerm& term : terms)
    sum += term.coefficient * power(um, term.exponent);
  return sum;
}

bool is_flat(const PowerTerm& term) {
  return term.coefficient == 0.0 || term.exponent == 0;
}

bool all_flat(const std::vector<PowerTerm>& terms) {
  return std::all_of(terms.begin(), terms.end(), is_flat);
}

} // namespace

double refractive_index(const ConstantIndex& law, double) {
  return law.n;
}

double refractive_index(const ThesisPolynomial&, double lambda_nm) {
  const double f = micrometres(lambda_nm);
  return 1.816731 +
         f * (-1.85629 + f * (3.514845 + f * (-3.12787 + f * (1.310301 - f * 0.2085667))));
}

double refractive_index(const ThesisLinear&, double lambda_nm) {
  return 1.56973 - 0.000054419 * (lambda_nm - kThesisFirst_nm);
}

double refractive_index(const ThesisScaled& law, double lambda_nm) {
  const double range = kThesisRange * law.v_number;
  return law.speed_of_light + range / 2.0 - range * (lambda_nm - kThesisFirst_nm) / kThesisSpan_nm;
}

double refractive_index(const Sellmeier& law, double lambda_nm) {
  const double um2 = square(micrometres(lambda_nm));
  double n2 = 1.0 + law.constant;
  for (const SellmeierTerm& term : law.terms)
    n2 += term.b * um2 / (um2 - term.c_um2);
  return std::sqrt(n2);
}

double refractive_index(const PowerSeries& law, double lambda_nm) {
  return std::sqrt(law.constant + sum_powers(law.terms, micrometres(lambda_nm)));
}

double refractive_index(const Formula4& law, double lambda_nm) {
  const double um = micrometres(lambda_nm);
  double n2 = law.constant + sum_powers(law.powers, um);
  for (const PoleTerm& term : law.poles)
    n2 += term.coefficient * power(um, term.exponent) / (square(um) - term.pole_um2);
  return std::sqrt(n2);
}

double refractive_index(const GasFormula& law, double lambda_nm) {
  const double inverse_um2 = 1.0 / square(micrometres(lambda_nm));
  double n = 1.0 + law.constant;
  for (const GasTerm& term : law.terms)
    n += term.a_per_um2 / (term.b_per_um2 - inverse_um2);
  return n;
}

bool is_achromatic(const ConstantIndex&) {
  return true;
}
bool is_achromatic(const ThesisPolynomial&) {
  return false;
}
bool is_achromatic(const ThesisLinear&) {
  return false;
}
bool is_achromatic(const ThesisScaled& law) {
  return law.v_number == 0.0;
}

bool is_achromatic(const Sellmeier& law) {
  // Without a pole (C = 0) a term is B at every wavelength.
  return std::all_of(law.terms.begin(), law.terms.end(),
                     [](const SellmeierTerm& term) { return term.b == 0.0 || term.c_um2 == 0.0; });
}

bool is_achromatic(const PowerSeries& law) {
  return all_flat(law.terms);
}

bool is_achromatic(const Formula4& law) {
  return all_flat(law.powers) &&
         std::all_of(law.poles.begin(), law.poles.end(),
                     [](const PoleTerm& term) { return term.coefficient == 0.0; });
}

bool is_achromatic(const GasFormula& law) {
  return std::all_of(law.terms.begin(), law.terms.end(),
                     [](const GasTerm& term) { return term.a_per_um2 == 0.0; });
}

} // namespace abbe
