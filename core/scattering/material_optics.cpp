#include "core/scattering/material_optics.h"

namespace abbe {

SurfaceOptics material_optics(const MaterialPlan& material, MediumId before, MediumId after,
                              PathWavelengths& wavelengths) {
  SurfaceOptics optics;
  optics.n_before = wavelengths.indices(before);
  optics.opaque = !material.dielectric && material.coat < 0;
  if (material.conductor) {
    optics.metal_n = material.metal_n.data();
    optics.metal_k = material.metal_k.data();
  } else if (!optics.opaque) {
    optics.n_after =
        material.coat >= 0 ? wavelengths.layer_indices(material.coat) : wavelengths.indices(after);
  }
  if (material.film >= 0)
    optics.film = {material.film_nm, wavelengths.layer_indices(material.film),
                   wavelengths.wavelengths_nm()};
  optics.fresnel = material.fresnel;
  optics.reflectivity = material.reflectivity.data();
  optics.transparency = material.transparency.data();
  return optics;
}

} // namespace abbe
