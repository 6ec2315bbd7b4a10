#include "core/bsdfs/thin_glass.h"

#include "core/optics/fresnel.h"

#include <cmath>

namespace abbe {
namespace {

/// The fractions for one polarisation, where a face reflects the part `r` of the light and a
/// passage leaves the part `a`.
Fractions between_faces(double r, double a) {
  const double t = 1.0 - r;
  if (!(t > 0.0)) return {1.0, 0.0}; // along the pane
  const double ra = r * a;
  const double transmitted = t * t * a / (1.0 - ra * ra);
  return {r + transmitted * a * r, transmitted};
}

/// The fractions of a pane whose glass has `eta` times the index around it.
Fractions pane(double cos_o, double eta, double absorption) {
  const auto cos_t = refracted_cosine(cos_o, eta);
  if (!cos_t) return {1.0, 0.0};
  const double s = (cos_o - eta * *cos_t) / (cos_o + eta * *cos_t);
  const double p = (eta * cos_o - *cos_t) / (eta * cos_o + *cos_t);
  const double left = absorption > 0.0 ? std::exp(-absorption / *cos_t) : 1.0;
  const Fractions across = between_faces(s * s, left), along = between_faces(p * p, left);
  return {0.5 * (across.reflected + along.reflected),
          0.5 * (across.transmitted + along.transmitted)};
}

/// Calls visit(band, fractions) for all bands. The fractions are computed anew only where the index
/// or the absorption differs from that of the band before.
template <class Visit>
void for_each_band(const ThinGlass& surface, const Incidence& in, Visit&& visit) {
  double eta = 0.0, absorption = -1.0;
  Fractions f{0.0, 0.0};
  for (int b = in.bands.first; b < in.bands.last; ++b) {
    const double next_eta = in.n_layer[b] / in.n_before[b];
    const auto next_absorption = static_cast<double>(surface.absorption[b]);
    if (next_eta != eta || next_absorption != absorption)
      f = pane(in.cos_o(), next_eta, next_absorption);
    eta = next_eta;
    absorption = next_absorption;
    visit(b, f);
  }
}

} // namespace

void ThinGlass::specular(const Incidence& in, const SpecularFactors& out) const {
  for_each_band(*this, in, [&](int b, const Fractions& f) {
    out.reflected[b] = static_cast<float>(f.reflected) * reflectivity[b];
    out.transmitted[b] = static_cast<float>(f.transmitted) * transparency[b];
  });
}

void ThinGlass::pass_straight(const Incidence& in, float* transmittance) const {
  for_each_band(*this, in, [&](int b, const Fractions& f) {
    transmittance[b] *= static_cast<float>(f.transmitted) * transparency[b];
  });
}

} // namespace abbe
