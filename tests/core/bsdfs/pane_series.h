#pragma once

#include <cmath>

namespace abbe::test {

/// The parts of the light that a pane of glass reflects and transmits.
struct PaneLight {
  double reflected = 0.0, transmitted = 0.0;
};

/// The sum over the reflections between the two faces, for unpolarised light at an angle in
/// radians, with Fresnel's equations in their form by angles. `absorption` is that at normal
/// incidence.
inline PaneLight pane_series(double angle, double n_before, double n_glass, double absorption) {
  const double inside = std::asin(n_before * std::sin(angle) / n_glass);
  const double normal = (n_glass - n_before) / (n_glass + n_before);
  const double left = std::exp(-absorption / std::cos(inside));
  PaneLight sum;
  for (const bool across : {true, false}) {
    const double ratio = angle == 0.0 ? normal
                         : across     ? std::sin(angle - inside) / std::sin(angle + inside)
                                      : std::tan(angle - inside) / std::tan(angle + inside);
    const double r = ratio * ratio;
    double within = 0.5 * (1.0 - r); // of half the light, what has just come into the glass
    sum.reflected += 0.5 * r;
    for (int face = 0; face < 4000; ++face) {
      within *= left;
      (face % 2 == 0 ? sum.transmitted : sum.reflected) += within * (1.0 - r);
      within *= r;
    }
  }
  return sum;
}

} // namespace abbe::test
