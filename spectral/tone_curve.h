#pragma once

#include "spectral/color.h"
#include "spectral/matrix3.h"

#include <cstdint>

namespace abbe {

/// How luminances of a scene become those of a display, where 1 is the display's white. `linear`:
/// they stay as they are. `filmic`: by a curve with a toe and a long shoulder, as film has it.
enum class ToneCurve : std::uint8_t { linear, filmic };

/// The curve's value. The filmic one is Hable's [Hab10]: with
///   h(x) = (x (A x + C B) + D E) / (x (A x + B) + D F) - E / F
/// and A = 0.15, B = 0.50, C = 0.10, D = 0.20, E = 0.02, F = 0.30 it is h(2 L) / h(11.2), so that a
/// luminance of 5.6 and more is white. Below 0 it goes on as its tangent there.
[[nodiscard]] double tone(ToneCurve curve, double luminance);

/// The colour with the curve's value as its luminance weights . rgb, and its chromaticity: what
/// then does not fit into the gamut is left to its mapping, which can tell a bright blue from one
/// that no display has.
[[nodiscard]] LinearRgb with_tone(const LinearRgb& color, ToneCurve curve,
                                  const Vector3& luminance_weights);

} // namespace abbe
