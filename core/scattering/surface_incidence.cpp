#include "core/scattering/surface_incidence.h"

namespace abbe {

Incidence surface_incidence(const Bsdf& bsdf, const Hit& hit, BandRange bands,
                            PathWavelengths& wavelengths) {
  Incidence in;
  in.bands = bands;
  in.n_before = wavelengths.indices(hit.medium_before);
  in.n_after = wavelengths.indices(hit.medium_after);
  const BsdfLayer layer = layer_of(bsdf);
  if (layer.index >= 0) in.n_layer = wavelengths.layer_indices(layer.index);
  if (layer.interferes) in.lambda_nm = wavelengths.wavelengths_nm();
  return in;
}

} // namespace abbe
