#pragma once

#include "spectral/color.h"
#include "spectral/matrix3.h"

#include <cstdint>

namespace abbe {

/// The cone-like responses that an adaptation scales: Bradford's [Lam85], or those of CAT16
/// [Li17].
enum class AdaptationMethod : std::uint8_t { bradford, cat16 };

/// The matrix on XYZ that takes the white `from` to the white `to` and other colours along: von
/// Kries's scaling of three cone-like responses. The eye is taken to adapt completely. Y = 1 stays
/// Y = 1 for whites only. Throws std::invalid_argument when a white has a response that is not
/// positive, as chromaticities far outside of what light can have do.
[[nodiscard]] Matrix3 adaptation(const Xyz& from, const Xyz& to, AdaptationMethod method);

/// The same by Bradford's responses.
[[nodiscard]] Matrix3 bradford_adaptation(const Xyz& from, const Xyz& to);

[[nodiscard]] Xyz transformed(const Matrix3& matrix, const Xyz& color);

} // namespace abbe
