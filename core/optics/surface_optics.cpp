#include "core/optics/surface_optics.h"

#include "core/optics/conductor_reflectance.h"
#include "core/optics/fresnel.h"
#include "core/optics/thin_film.h"

#include <utility>

namespace abbe {
namespace {

Fractions without_loss(double reflected) {
  return {reflected, 1.0 - reflected};
}

} // namespace

Fractions SurfaceOptics::fractions(int b, double cos_i) const {
  const bool film_shows = film.thickness_nm > 0.0;
  if (opaque && (!metal_n || !fresnel)) return {1.0, 0.0};
  if (opaque) {
    const double reflected =
        film_shows ? thin_film_reflectance(cos_i, n_before[b], film.index[b],
                                           {metal_n[b], -static_cast<double>(metal_k[b])},
                                           film.thickness_nm, film.lambda_nm[b])
                   : conductor_reflectance(cos_i, n_before[b], metal_n[b], metal_k[b]);
    return {reflected, 0.0};
  }
  const double eta = n_after[b] / n_before[b];
  const auto cos_t = refracted_cosine(cos_i, eta);
  if (!cos_t) return {1.0, 0.0};
  if (!fresnel) return {1.0, 1.0};
  const double reflected =
      film_shows ? thin_film_reflectance(cos_i, n_before[b], film.index[b], n_after[b],
                                         film.thickness_nm, film.lambda_nm[b])
                 : fresnel_reflectance(cos_i, *cos_t, eta);
  return without_loss(reflected);
}

void scatter_smooth(const SurfaceOptics& optics, double cos_i, int first, int last,
                    Transport transport, float* reflected, float* transmitted) {
  const bool clear_film = optics.film.thickness_nm > 0.0 && !optics.opaque && optics.fresnel;
  if (clear_film)
    thin_film_reflectances(cos_i, optics.n_before, optics.film.index, optics.n_after,
                           optics.film.thickness_nm, optics.film.lambda_nm, first, last, reflected);
  for (int b = first; b < last; ++b) {
    const Fractions f =
        clear_film ? without_loss(static_cast<double>(reflected[b])) : optics.fractions(b, cos_i);
    reflected[b] = static_cast<float>(f.reflected * optics.reflection_scale(b));
    if (!transmitted) continue;
    const double ratio =
        transport == Transport::radiance ? optics.n_before[b] / optics.n_after[b] : 1.0;
    transmitted[b] =
        static_cast<float>(f.transmitted * ratio * ratio * optics.transmission_scale(b));
  }
}

void attenuate_straight(const SurfaceOptics& optics, double cos_i, int first, int last,
                        float* transmittance) {
  SurfaceOptics reversed = optics;
  std::swap(reversed.n_before, reversed.n_after);
  for (int b = first; b < last; ++b) {
    const SurfaceOptics& thin_first = optics.n_before[b] <= optics.n_after[b] ? optics : reversed;
    transmittance[b] *= static_cast<float>(thin_first.fractions(b, cos_i).transmitted *
                                           optics.transmission_scale(b));
  }
}

bool SurfaceOptics::alike(int first, int last) const {
  if (film.thickness_nm > 0.0) return last - first <= 1;
  bool same = true;
  for (int b = first; b < last; ++b)
    same &= n_before[b] == n_before[first];
  if (opaque && !metal_n) return true;
  if (opaque)
    for (int b = first; b < last; ++b)
      same &= metal_n[b] == metal_n[first] && metal_k[b] == metal_k[first];
  else
    for (int b = first; b < last; ++b)
      same &= n_after[b] == n_after[first];
  return same;
}

} // namespace abbe
