#pragma once

namespace abbe {

/// The mean of Fresnel's transmittance for unpolarised light from all directions of a hemisphere,
/// weighted by their cosine: 2 times the integral of T(mu) mu. `eta` is n behind / n on the side
/// of the light. From the thinner side by Walsh's closed form [Judd42]; from the denser side by
/// reciprocity, T(eta) = eta^2 T(1 / eta).
[[nodiscard]] double diffuse_transmittance(double eta);

} // namespace abbe
