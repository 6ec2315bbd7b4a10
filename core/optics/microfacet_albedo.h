#pragma once

#include "core/optics/microfacet.h"

namespace abbe {

/// Of light from a direction with cosine `mu`, the part that GGX facets that reflect all of it
/// return after one reflection; the rest meets further facets. By quadrature over the visible
/// normals.
[[nodiscard]] double reflected_once(const Ggx& ggx, double mu);

/// Of the flux from a direction with cosine `mu`, what clear facets return and let through after
/// one interaction. `eta` is n behind / n on the side of the light.
struct OnceScattered {
  double reflected, transmitted;
};
[[nodiscard]] OnceScattered scattered_once(const Ggx& ggx, double mu, double eta);

} // namespace abbe
