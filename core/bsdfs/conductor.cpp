#include "core/bsdfs/conductor.h"

#include "core/optics/conductor_reflectance.h"

namespace abbe {

void Conductor::specular(const Incidence& in, const SpecularFactors& out) const {
  float* reflected = out.reflected;
  if (film.present()) {
    const SurfaceOptics metal = optics(in);
    for (int b = in.bands.first; b < in.bands.last; ++b)
      reflected[b] = static_cast<float>(metal.fractions(b, in.cos_o()).reflected *
                                        static_cast<double>(reflectivity[b]));
    return;
  }
  const float* factor = reflectivity.data();
  const double cos_o = in.cos_o();
  for (int b = in.bands.first; b < in.bands.last; ++b)
    reflected[b] =
        static_cast<float>(conductor_reflectance(cos_o, in.n_before[b], n[b], k[b])) * factor[b];
}

SurfaceOptics Conductor::optics(const Incidence& in) const {
  SurfaceOptics optics;
  optics.n_before = in.n_before;
  optics.opaque = true;
  optics.metal_n = n.data();
  optics.metal_k = k.data();
  optics.film = film.optics(in);
  optics.reflectivity = reflectivity.data();
  return optics;
}

} // namespace abbe
