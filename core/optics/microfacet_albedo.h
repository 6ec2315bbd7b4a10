#pragma once

#include "core/optics/microfacet.h"

namespace abbe {

/// The part of the light from a direction with cosine `mu` that leaves perfectly reflecting GGX
/// facets after one reflection, by quadrature over the visible normals. The rest meets further
/// facets.
[[nodiscard]] double reflected_once(const Ggx& ggx, double mu);

/// The parts of the flux that leave clear facets after one interaction.
struct OnceScattered {
  double reflected, transmitted;
};
/// These parts for a direction with cosine `mu`. `eta` is n behind / n on the side of the light.
[[nodiscard]] OnceScattered scattered_once(const Ggx& ggx, double mu, double eta);

} // namespace abbe
