#pragma once

namespace abbe {

/// The reflectance of unpolarised light at a metal of complex index n - i k behind a clear medium
/// of index n_before [BW99, 14.2]. With eta = n / n_before, kappa = k / n_before, s = sin i:
///   a^2 + b^2 = sqrt((eta^2 - kappa^2 - s^2)^2 + 4 eta^2 kappa^2)
///   a^2 = (a^2 + b^2 + eta^2 - kappa^2 - s^2) / 2
///   R_s = (a^2 + b^2 - 2 a cos i + cos^2 i) / (a^2 + b^2 + 2 a cos i + cos^2 i)
///   R_p = R_s (cos^2 i (a^2 + b^2) - 2 a cos i s^2 + s^4) / (the same with + 2 a)
/// With k = 0 this is Fresnel's formula for glass.
[[nodiscard]] double conductor_reflectance(double cos_i, double n_before, double n, double k);

} // namespace abbe
