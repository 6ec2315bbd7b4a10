#include "io/selftest/film_rows.h"

#include "io/selftest/single_ray.h"
#include "io/selftest/small_picture.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace abbe {
namespace {

struct FilmOnGlass {
  double film, glass; ///< indices; the light comes from air
  double thickness_nm;
};

/// Airy's formula for a clear film [BW99, 7.6], from the reflectances' amplitudes at its two faces:
/// R = (r1^2 + r2^2 + 2 r1 r2 cos 2d) / (1 + r1^2 r2^2 + 2 r1 r2 cos 2d).
double airy(const FilmOnGlass& f, double lambda_nm, double angle_deg) {
  const double sin_i = std::sin(angle_deg * kRadiansPerDegree);
  const auto cosine = [sin_i](double n) { return std::sqrt(1.0 - sin_i * sin_i / (n * n)); };
  const double c0 = cosine(1.0), c1 = cosine(f.film), c2 = cosine(f.glass);
  const double phase =
      4.0 * std::numbers::pi * f.film * f.thickness_nm * c1 / lambda_nm; // 2d above
  const auto reflectance = [&](double r1, double r2) {
    const double both = 2.0 * r1 * r2 * std::cos(phase);
    return (r1 * r1 + r2 * r2 + both) / (1.0 + r1 * r1 * r2 * r2 + both);
  };
  const double across = reflectance((c0 - f.film * c1) / (c0 + f.film * c1),
                                    (f.film * c1 - f.glass * c2) / (f.film * c1 + f.glass * c2));
  const double along = reflectance((f.film * c0 - c1) / (f.film * c0 + c1),
                                   (f.glass * c1 - f.film * c2) / (f.glass * c1 + f.film * c2));
  return 0.5 * (across + along);
}

/// What the film reflects, in a picture of a block of such glass; what enters it is absorbed.
double seen(const FilmOnGlass& f, double lambda_nm, double angle_deg) {
  return radiance_seen(fmt::format("background E 1 defaultMaterials reflectivity 1 transparency 1 "
                                   "thinFilm {} {} speedOfLight {} absorption 1e9 "
                                   "push translate 0 0 -1 cube pop",
                                   exact_text(f.thickness_nm), exact_text(f.film),
                                   exact_text(f.glass)),
                       lambda_nm, angle_deg);
}

} // namespace

SelftestRows film_rows() {
  constexpr double kNm = 550.0;
  SelftestRows rows;
  for (const double n1 : {1.38, 2.1}) {
    const FilmOnGlass quarter{n1, 1.5, kNm / (4.0 * n1)}, half{n1, 1.5, kNm / (2.0 * n1)};
    rows.push_back({"film", fmt::format("quarter wave of n = {} on 1.5", n1),
                    "((n2 - n1^2)/(n2 + n1^2))^2", std::pow((1.5 - n1 * n1) / (1.5 + n1 * n1), 2),
                    seen(quarter, kNm, 0.0), 1e-6});
    rows.push_back({"film", fmt::format("half wave of n = {} on 1.5", n1),
                    "as if it were not there", 0.04, seen(half, kNm, 0.0), 1e-6});
  }
  for (const double nm : {450.0, 550.0, 650.0})
    for (const double angle : {0.0, 60.0}) {
      const FilmOnGlass f{1.33, 1.7, 400.0};
      rows.push_back({"film",
                      fmt::format("400 nm of 1.33 on 1.7, {:.0f} deg, {:.0f} nm", angle, nm),
                      "Airy's formula", airy(f, nm, angle), seen(f, nm, angle), 1e-6});
    }
  return rows;
}

} // namespace abbe
