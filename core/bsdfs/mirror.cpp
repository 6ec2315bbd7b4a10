#include "core/bsdfs/mirror.h"

namespace abbe {

void Mirror::specular(const Incidence& in, const SpecularFactors& out) const {
  std::copy(reflectivity.data() + in.bands.first, reflectivity.data() + in.bands.last,
            out.reflected + in.bands.first);
}

SurfaceOptics Mirror::optics(const Incidence& in) const {
  SurfaceOptics optics;
  optics.n_before = in.n_before;
  optics.opaque = true;
  optics.reflectivity = reflectivity.data();
  return optics;
}

} // namespace abbe
