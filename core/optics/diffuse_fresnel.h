#pragma once

namespace abbe {

/// The cosine-weighted mean of Fresnel's transmittance for unpolarised light over a hemisphere: 2
/// times the integral of T(mu) mu. `eta` is n behind / n on the side of the light. From the thinner
/// side it is Walsh's closed form [Judd42]; from the denser side it follows by reciprocity,
/// T(eta) = eta^2 T(1 / eta).
[[nodiscard]] double diffuse_transmittance(double eta);

} // namespace abbe
