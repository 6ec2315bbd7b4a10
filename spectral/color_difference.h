#pragma once

#include "spectral/color.h"

namespace abbe {

/// CIE 1976 L*, a*, b*.
struct Lab {
  double l = 0.0;
  double a = 0.0;
  double b = 0.0;
  friend bool operator==(const Lab&, const Lab&) = default;
};

/// CIELAB of a colour seen under `white` [CIE15]; the components of `white` must be positive.
[[nodiscard]] Lab to_lab(const Xyz& color, const Xyz& white);

/// The CIEDE2000 colour difference with kL = kC = kH = 1 [SWD05]; about 1 is just noticeable.
[[nodiscard]] double delta_e_2000(const Lab& first, const Lab& second);

} // namespace abbe
