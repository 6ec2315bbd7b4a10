#include "core/scattering/dielectric.h"

#include "core/optics/fresnel.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace abbe {
namespace {

/// True when the medium has one index for all these bands. Most of a scene's glass may disperse,
/// but where it does not, Fresnel's equations need solving once and not per band.
bool alike(const double* n, int first, int last) {
  // By their bits, which whole registers can compare; indices are no zeros of two signs.
  const auto bits = [n](int b) { return std::bit_cast<std::uint64_t>(n[b]); };
  std::uint64_t differing = 0;
  for (int b = first; b < last; ++b)
    differing |= bits(b) ^ bits(first);
  return differing == 0;
}

struct Parts {
  float reflected, transmitted;
};

// In line, so that the loop over bands can be done for several at once.
[[gnu::always_inline]] inline Parts parts(bool by_fresnel, double cos_i, double n_before,
                                          double n_after, Transport transport) {
  const double eta = n_after / n_before, inverse = n_before / n_after;
  const double cos2_t = 1.0 - (1.0 - cos_i * cos_i) * (inverse * inverse);
  const bool passes = cos2_t > 0.0;
  const double cos_t = std::sqrt(std::max(cos2_t, 0.0));
  const double fresnel = passes ? fresnel_reflectance(cos_i, cos_t, eta) : 1.0;
  const double reflect = by_fresnel ? fresnel : 1.0;
  const double transmit = by_fresnel ? 1.0 - fresnel : (passes ? 1.0 : 0.0);
  return {static_cast<float>(reflect),
          static_cast<float>(transport == Transport::radiance ? transmit * (inverse * inverse)
                                                              : transmit)};
}

float passed_straight(bool by_fresnel, double cos_i, double eta) {
  return static_cast<float>(by_fresnel ? 1.0 - fresnel_reflectance(cos_i, std::max(eta, 1.0 / eta))
                                       : 1.0);
}

} // namespace

void scatter_dielectric(const MaterialPlan& material, double cos_i, const double* n_before,
                        const double* n_after, int first, int last, DielectricScatter& scatter,
                        Transport transport) {
  const float* reflectivity = material.reflectivity.data();
  const float* transparency = material.transparency.data();
  float* reflected = scatter.reflected.data();
  float* transmitted = scatter.transmitted.data();
  if (alike(n_before, first, last) && alike(n_after, first, last)) {
    const Parts p = parts(material.fresnel, cos_i, n_before[first], n_after[first], transport);
    for (int b = first; b < last; ++b) {
      reflected[b] = p.reflected * reflectivity[b];
      transmitted[b] = p.transmitted * transparency[b];
    }
    return;
  }
  for (int b = first; b < last; ++b) {
    const Parts p = parts(material.fresnel, cos_i, n_before[b], n_after[b], transport);
    reflected[b] = p.reflected * reflectivity[b];
    transmitted[b] = p.transmitted * transparency[b];
  }
}

void attenuate_straight(const MaterialPlan& material, double cos_i, const double* n_before,
                        const double* n_after, int first, int last, float* transmittance) {
  const float* transparency = material.transparency.data();
  if (alike(n_before, first, last) && alike(n_after, first, last)) {
    const float passed = passed_straight(material.fresnel, cos_i, n_after[first] / n_before[first]);
    for (int b = first; b < last; ++b)
      transmittance[b] *= passed * transparency[b];
    return;
  }
  for (int b = first; b < last; ++b)
    transmittance[b] *=
        passed_straight(material.fresnel, cos_i, n_after[b] / n_before[b]) * transparency[b];
}

} // namespace abbe
