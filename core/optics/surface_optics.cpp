#include "core/optics/surface_optics.h"

#include "core/optics/conductor_reflectance.h"

namespace abbe {

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
  if (!film_shows || !fresnel)
    return dielectric_fractions(fresnel, cos_i, n_before[b], n_after[b]);
  const double reflected = thin_film_reflectance(cos_i, n_before[b], film.index[b], n_after[b],
                                                 film.thickness_nm, film.lambda_nm[b]);
  return {reflected, 1.0 - reflected};
}

bool SurfaceOptics::alike(int first, int last) const {
  if (film.thickness_nm > 0.0) return last - first <= 1;
  bool same = true;
  for (int b = first; b < last; ++b)
    same &= n_before[b] == n_before[first];
  if (opaque && (!metal_n || !fresnel)) return true;
  if (opaque)
    for (int b = first; b < last; ++b)
      same &= metal_n[b] == metal_n[first] && metal_k[b] == metal_k[first];
  else
    for (int b = first; b < last; ++b)
      same &= n_after[b] == n_after[first];
  return same;
}

} // namespace abbe
