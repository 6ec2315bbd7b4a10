#pragma once

namespace abbe {

/// n = a + b / L^2 + c / L^4 with L in micrometres [Cau36]: good for glass in visible light.
struct Cauchy {
  double a = 1.0;
  double b_um2 = 0.0;
  double c_um4 = 0.0;
  friend bool operator==(const Cauchy&, const Cauchy&) = default;
};

[[nodiscard]] double refractive_index(const Cauchy& law, double lambda_nm);
[[nodiscard]] bool is_achromatic(const Cauchy& law);

/// The two-term Cauchy law with this n_d and this Abbe number V_d = (n_d - 1)/(n_F - n_C). Both are
/// met exactly; what lies between is the law's, off by some 1e-4 for common glasses.
[[nodiscard]] Cauchy cauchy_of_abbe(double n_d, double v_d);

} // namespace abbe
