#pragma once

#include "spectral/color.h"
#include "spectral/matrix3.h"

namespace abbe {

/// The matrix on XYZ that takes the white `from` to the white `to` and other colours along: von
/// Kries's scaling of three cone-like responses by Bradford's matrix [Lam85]. Y = 1 stays Y = 1 for
/// whites only. Throws std::invalid_argument when a white has a response that is not positive, as
/// chromaticities far outside of what light can have do.
[[nodiscard]] Matrix3 bradford_adaptation(const Xyz& from, const Xyz& to);

[[nodiscard]] Xyz transformed(const Matrix3& matrix, const Xyz& color);

} // namespace abbe
