#pragma once

#include <vector>

namespace abbe {

// Each law is a struct of its coefficients with two functions: n at a wavelength in nm, and whether
// n is the same at all wavelengths. L is the wavelength in micrometres, as makers of glass print
// it.

/// The same n everywhere.
struct ConstantIndex {
  double n = 1.0;
  friend bool operator==(const ConstantIndex&, const ConstantIndex&) = default;
};

/// The thesis's first method, a quintic fitted to crystal quartz [War05, section 4.5.2]. Its
/// "frequency" is the wavelength in micrometres: only then are its values indices at all (1.4465 at
/// 589 nm). They are not those of quartz (1.544), as the thesis found too.
struct ThesisPolynomial {
  friend bool operator==(const ThesisPolynomial&, const ThesisPolynomial&) = default;
};

/// The thesis's second method, n = 1.56973 - 0.000054419 (lambda - 380) with lambda in nm [War05].
/// Its slope is the range of quartz divided by 405 nm, so its "frequency" counts from 380 nm.
struct ThesisLinear {
  friend bool operator==(const ThesisLinear&, const ThesisLinear&) = default;
};

/// The thesis's third method [War05], in our reading: n = speed_of_light + range/2
/// - range (lambda - 380)/405 with range = 0.02204 v_number, quartz's range times `Vnum`.
struct ThesisScaled {
  double speed_of_light = 1.0; ///< the material file's `speedOfLight`: the general index
  double v_number = 1.0;       ///< its `Vnum`: a factor on dispersion, not an Abbe number
  friend bool operator==(const ThesisScaled&, const ThesisScaled&) = default;
};

/// One resonance: B (no unit) and C (um squared).
struct SellmeierTerm {
  double b = 0.0;
  double c_um2 = 0.0;
  friend bool operator==(const SellmeierTerm&, const SellmeierTerm&) = default;
};

/// n^2 = 1 + constant + sum B L^2 / (L^2 - C) [Sel71].
struct Sellmeier {
  double constant = 0.0;
  std::vector<SellmeierTerm> terms;
  friend bool operator==(const Sellmeier&, const Sellmeier&) = default;
};

/// coefficient L^exponent, the coefficient in um^-exponent.
struct PowerTerm {
  double coefficient = 0.0;
  int exponent = 0;
  friend bool operator==(const PowerTerm&, const PowerTerm&) = default;
};

/// n^2 = constant + sum a_i L^p_i: Schott's older formula, with p = 2, -2, -4 ... [Pol24].
struct PowerSeries {
  double constant = 1.0;
  std::vector<PowerTerm> terms;
  friend bool operator==(const PowerSeries&, const PowerSeries&) = default;
};

/// coefficient L^exponent / (L^2 - pole).
struct PoleTerm {
  double coefficient = 0.0;
  int exponent = 0;
  double pole_um2 = 0.0;
  friend bool operator==(const PoleTerm&, const PoleTerm&) = default;
};

/// n^2 = constant + sum poles + sum powers: "formula 4" of refractiveindex.info [Pol24].
struct Formula4 {
  double constant = 1.0;
  std::vector<PoleTerm> poles;
  std::vector<PowerTerm> powers;
  friend bool operator==(const Formula4&, const Formula4&) = default;
};

/// a / (b - L^-2), both in um^-2.
struct GasTerm {
  double a_per_um2 = 0.0;
  double b_per_um2 = 0.0;
  friend bool operator==(const GasTerm&, const GasTerm&) = default;
};

/// n = 1 + constant + sum a / (b - L^-2): air and other gases [Cid96].
struct GasFormula {
  double constant = 0.0;
  std::vector<GasTerm> terms;
  friend bool operator==(const GasFormula&, const GasFormula&) = default;
};

[[nodiscard]] double refractive_index(const ConstantIndex& law, double lambda_nm);
[[nodiscard]] double refractive_index(const ThesisPolynomial& law, double lambda_nm);
[[nodiscard]] double refractive_index(const ThesisLinear& law, double lambda_nm);
[[nodiscard]] double refractive_index(const ThesisScaled& law, double lambda_nm);
[[nodiscard]] double refractive_index(const Sellmeier& law, double lambda_nm);
[[nodiscard]] double refractive_index(const PowerSeries& law, double lambda_nm);
[[nodiscard]] double refractive_index(const Formula4& law, double lambda_nm);
[[nodiscard]] double refractive_index(const GasFormula& law, double lambda_nm);

[[nodiscard]] bool is_achromatic(const ConstantIndex& law);
[[nodiscard]] bool is_achromatic(const ThesisPolynomial& law);
[[nodiscard]] bool is_achromatic(const ThesisLinear& law);
[[nodiscard]] bool is_achromatic(const ThesisScaled& law);
[[nodiscard]] bool is_achromatic(const Sellmeier& law);
[[nodiscard]] bool is_achromatic(const PowerSeries& law);
[[nodiscard]] bool is_achromatic(const Formula4& law);
[[nodiscard]] bool is_achromatic(const GasFormula& law);

} // namespace abbe
