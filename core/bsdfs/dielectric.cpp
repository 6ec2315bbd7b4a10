#include "core/bsdfs/dielectric.h"

#include "core/optics/fresnel.h"
#include "core/optics/thin_film.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace abbe {
namespace {

/// True when the medium has one index for all these bands. Fresnel's equations then need to be
/// solved only once.
bool alike(const double* n, int first, int last) {
  // Compare bits, since that works in whole registers. Equal indices have equal bits: none is 0.
  const auto bits = [n](int b) { return std::bit_cast<std::uint64_t>(n[b]); };
  std::uint64_t differing = 0;
  for (int b = first; b < last; ++b)
    differing |= bits(b) ^ bits(first);
  return differing == 0;
}

bool one_boundary(const Incidence& in) {
  return alike(in.n_before, in.bands.first, in.bands.last) &&
         alike(in.n_after, in.bands.first, in.bands.last);
}

struct Parts {
  float reflected, transmitted;
};

// In line so that the loop over bands can be vectorised.
[[gnu::always_inline]] inline Parts parts(bool fresnel, double cos_o, double n_before,
                                          double n_after, Transport transport) {
  const Fractions f = dielectric_fractions(fresnel, cos_o, n_before, n_after);
  const double inverse = n_before / n_after;
  const double transmitted =
      transport == Transport::radiance ? f.transmitted * (inverse * inverse) : f.transmitted;
  return {static_cast<float>(f.reflected), static_cast<float>(transmitted)};
}

float passed_straight(bool fresnel, double cos_o, double eta) {
  return static_cast<float>(fresnel ? 1.0 - fresnel_reflectance(cos_o, std::max(eta, 1.0 / eta))
                                    : 1.0);
}

void filmed(const Dielectric& surface, const Incidence& in, const SpecularFactors& out) {
  thin_film_reflectances(in.cos_o(), in.n_before, surface.film.optics(in), in.n_after,
                         {out.reflected, in.bands});
  for (int b = in.bands.first; b < in.bands.last; ++b) {
    const auto reflected = static_cast<double>(out.reflected[b]);
    const double ratio = in.transport == Transport::radiance ? in.n_before[b] / in.n_after[b] : 1.0;
    out.reflected[b] = static_cast<float>(reflected * static_cast<double>(surface.reflectivity[b]));
    out.transmitted[b] = static_cast<float>((1.0 - reflected) * ratio * ratio *
                                            static_cast<double>(surface.transparency[b]));
  }
}

void pass_film(const Dielectric& surface, const Incidence& in, float* transmittance) {
  const SurfaceOptics optics = surface.optics(in);
  SurfaceOptics reversed = optics;
  std::swap(reversed.n_before, reversed.n_after);
  for (int b = in.bands.first; b < in.bands.last; ++b) {
    const SurfaceOptics& thin_first = in.n_before[b] <= in.n_after[b] ? optics : reversed;
    transmittance[b] *= static_cast<float>(thin_first.fractions(b, in.cos_o()).transmitted *
                                           optics.transmission_scale(b));
  }
}

} // namespace

void Dielectric::specular(const Incidence& in, const SpecularFactors& out) const {
  if (film.present()) {
    filmed(*this, in, out);
    return;
  }
  const float* reflect = reflectivity.data();
  const float* transmit = transparency.data();
  float* reflected = out.reflected;
  float* transmitted = out.transmitted;
  const double cos_o = in.cos_o();
  const double* n_before = in.n_before;
  const double* n_after = in.n_after;
  const auto [first, last] = in.bands;
  if (one_boundary(in)) {
    const Parts p = parts(fresnel, cos_o, n_before[first], n_after[first], in.transport);
    for (int b = first; b < last; ++b) {
      reflected[b] = p.reflected * reflect[b];
      transmitted[b] = p.transmitted * transmit[b];
    }
    return;
  }
  const bool by_fresnel = fresnel;
  const Transport transport = in.transport;
  for (int b = first; b < last; ++b) {
    const Parts p = parts(by_fresnel, cos_o, n_before[b], n_after[b], transport);
    reflected[b] = p.reflected * reflect[b];
    transmitted[b] = p.transmitted * transmit[b];
  }
}

void Dielectric::pass_straight(const Incidence& in, float* transmittance) const {
  if (film.present()) {
    pass_film(*this, in, transmittance);
    return;
  }
  const float* transmit = transparency.data();
  const double cos_o = in.cos_o();
  if (one_boundary(in)) {
    const float passed =
        passed_straight(fresnel, cos_o, in.n_after[in.bands.first] / in.n_before[in.bands.first]);
    for (int b = in.bands.first; b < in.bands.last; ++b)
      transmittance[b] *= passed * transmit[b];
    return;
  }
  for (int b = in.bands.first; b < in.bands.last; ++b)
    transmittance[b] *=
        passed_straight(fresnel, cos_o, in.n_after[b] / in.n_before[b]) * transmit[b];
}

SurfaceOptics Dielectric::optics(const Incidence& in) const {
  SurfaceOptics optics;
  optics.n_before = in.n_before;
  optics.n_after = in.n_after;
  optics.film = film.optics(in);
  optics.fresnel = fresnel;
  optics.reflectivity = reflectivity.data();
  optics.transparency = transparency.data();
  return optics;
}

} // namespace abbe
