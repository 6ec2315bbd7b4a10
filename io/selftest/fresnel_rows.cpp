#include "io/selftest/fresnel_rows.h"

#include "io/selftest/single_ray.h"
#include "io/selftest/small_picture.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>

namespace abbe {
namespace {

using Complex = std::complex<double>;

/// Fresnel's reflectance of unpolarised light in air, with complex numbers: it serves glass and
/// metals.
double fresnel(Complex n, double angle_deg) {
  const double angle = angle_deg * kRadiansPerDegree;
  const double cos_i = std::cos(angle), sin_i = std::sin(angle);
  const Complex inside = std::sqrt(n * n - sin_i * sin_i); // n cos t
  const double across = std::norm((cos_i - inside) / (cos_i + inside));
  const double along = std::norm((n * n * cos_i - inside) / (n * n * cos_i + inside));
  return 0.5 * (across + along);
}

/// A block whose upper face lies in z = 0, under a sky of radiance 1. What enters the glass is
/// absorbed, so that the picture shows what is reflected.
std::string block(const std::string& material) {
  return "background E 1 " + material + " push translate 0 0 -1 cube pop";
}

} // namespace

SelftestRows fresnel_rows() {
  SelftestRows rows;
  // n of N-BK7 at the middle of a band, 500 nm, by a script outside this program.
  constexpr double kBk7 = 1.521414475773, kNm = 500.0;
  for (const double angle : {0.0, 30.0, 60.0, 85.0})
    rows.push_back({"Fresnel", fmt::format("N-BK7 reflects at {:.0f} deg, {:.0f} nm", angle, kNm),
                    "Fresnel's equations", fresnel(kBk7, angle),
                    radiance_seen(block("glass N-BK7 absorption 1e9"), kNm, angle), 1e-6});
  const double brewster = std::atan(kBk7) / kRadiansPerDegree;
  const double across = (kBk7 * kBk7 - 1.0) / (kBk7 * kBk7 + 1.0);
  rows.push_back({"Fresnel", "N-BK7 at Brewster's angle", "((n^2-1)/(n^2+1))^2 / 2",
                  0.5 * across * across,
                  radiance_seen(block("glass N-BK7 absorption 1e9"), kNm, brewster), 1e-6});
  // n and k of gold at 550 nm: Johnson and Christy 1972, linear between their points.
  const Complex gold(0.424149, -2.472051);
  for (const double angle : {0.0, 60.0, 80.0})
    rows.push_back({"Fresnel", fmt::format("gold reflects at {:.0f} deg, 550 nm", angle),
                    "Fresnel's equations, n - ik", fresnel(gold, angle),
                    radiance_seen(block("metal Au"), 550.0, angle), 2e-6});
  const Rendering plate = rendered(narrow_view() + "defaultMaterials speedOfLight 1.5 "
                                                   "transparency 1 reflectivity 1 cube");
  rows.push_back({"Fresnel", "a plate of n = 1.5 lets through", "(1 - R) / (1 + R), R = 0.04",
                  0.96 / 1.04, 1.0 - plate.film.alpha(0, 0), 1e-6});
  // A pencil of rays that leaves glass widens, so that its radiance falls by n^2. The card reflects
  // nothing of what the face throws back.
  const std::string card = "defaultMaterials emissive 1 1 1 scale 0.9 0.9 1 square";
  const double r0 = std::pow((kBk7 - 1.0) / (kBk7 + 1.0), 2);
  rows.push_back({"Fresnel", "a shining card inside N-BK7, 500 nm", "(1 - R) / n^2",
                  (1.0 - r0) / (kBk7 * kBk7),
                  radiance_seen("glass N-BK7 cube " + card, kNm) / radiance_seen(card, kNm), 1e-6});
  return rows;
}

} // namespace abbe
