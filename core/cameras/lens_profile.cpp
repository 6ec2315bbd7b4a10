#include "core/cameras/lens_profile.h"

#include "geometry/booleans/lens.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abbe {
namespace {

/// 1 - (1 + k) c^2 h^2: below 0 where the conic has no point.
double under_root(const LensProfile& p, double height2) {
  return 1.0 - (1.0 + p.conic) * p.curvature * p.curvature * height2;
}

double conic_sag(const LensProfile& p, double height2) {
  return p.curvature * height2 / (1.0 + std::sqrt(std::max(0.0, under_root(p, height2))));
}

/// a_2 h^2 + a_4 h^4 + ..., by Horner's rule.
double even_sag(const LensProfile& p, double height2) {
  double sum = 0.0;
  for (std::size_t i = p.even_terms.size(); i-- > 0;)
    sum = (sum + p.even_terms[i]) * height2;
  return sum;
}

/// The sag is nowhere farther from that of the conic up to this height.
double most_even_sag(const LensProfile& p, double height2) {
  double sum = 0.0;
  for (std::size_t i = p.even_terms.size(); i-- > 0;)
    sum = (sum + std::abs(p.even_terms[i])) * height2;
  return sum;
}

} // namespace

double LensProfile::vertex_curvature() const {
  return curvature + (even_terms.empty() ? 0.0 : 2.0 * even_terms.front());
}

bool LensProfile::reaches(double height) const {
  return under_root(*this, height * height) >= 0.0;
}

double LensProfile::sag(double height) const {
  return conic_sag(*this, height * height) + even_sag(*this, height * height);
}

double LensProfile::most_sag(double height) const {
  if (even_terms.empty() && conic == 0.0)
    return curvature == 0.0
               ? 0.0
               : abbe::sag(1.0 / curvature, std::min(height, std::abs(1.0 / curvature)));
  return conic_sag(*this, height * height) + most_even_sag(*this, height * height);
}

double LensProfile::slope(double height2) const {
  double sum = 0.0; // of i a_2i h^(2i - 2)
  for (std::size_t i = even_terms.size(); i-- > 0;)
    sum = sum * height2 + static_cast<double>(i + 1) * even_terms[i];
  return 0.5 * curvature / std::sqrt(under_root(*this, height2)) + sum;
}

/// The sag lies between two planes, at which the ray is before and behind the surface: a bracket,
/// which Newton's steps narrow, or halving where these leave it, until doubles allow no more.
double meet_profile(const LensProfile& profile, double semi_diameter, const dvec3& q,
                    const dvec3& d) {
  const double most2 = semi_diameter * semi_diameter;
  const auto height2_at = [&](double t) {
    const double x = q.x + t * d.x, y = q.y + t * d.y;
    return x * x + y * y;
  };
  // How far behind the surface, along +z, the ray is.
  const auto behind = [&](double t) {
    const double h2 = std::min(height2_at(t), most2);
    return t * d.z - (conic_sag(profile, h2) + even_sag(profile, h2));
  };
  const double rim = conic_sag(profile, most2), beside = most_even_sag(profile, most2);
  double low = (std::min(0.0, rim) - beside) / d.z, high = (std::max(0.0, rim) + beside) / d.z;
  // From here on `low` is where the ray is before the surface, whichever way it runs.
  double t = std::clamp(0.0, std::min(low, high), std::max(low, high));
  for (;;) {
    const double f = behind(t);
    if (f == 0.0) return t;
    (f < 0.0 ? low : high) = t;
    const double h2 = height2_at(t);
    const double rise =
        h2 < most2 ? 2.0 * profile.slope(h2) * (d.x * (q.x + t * d.x) + d.y * (q.y + t * d.y))
                   : 0.0;
    const auto [least, most] = std::minmax(low, high);
    double next = t - f / (d.z - rise);
    if (!(next > least && next < most)) next = 0.5 * (least + most);
    if (!(next > least && next < most)) return t;
    // A step that no longer changes the place has reached what the sag is computed to.
    if (std::abs(next - t) <= 0x1p-51 * std::max(std::abs(t), std::abs(next))) return next;
    t = next;
  }
}

} // namespace abbe
