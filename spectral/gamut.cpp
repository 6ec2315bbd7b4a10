#include "spectral/gamut.h"

#include <algorithm>

namespace abbe {
namespace {

LinearRgb clip(const LinearRgb& c) {
  return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
}

// Largest t <= 1 for which grey + t (component - grey) stays in 0..1, with grey inside 0..1.
double reach(double component, double grey) {
  if (component > 1.0) return (1.0 - grey) / (component - grey);
  if (component < 0.0) return grey / (grey - component);
  return 1.0;
}

LinearRgb desaturate(const LinearRgb& c) {
  const double grey = luminance(c);
  if (grey >= 1.0) return {1.0, 1.0, 1.0};
  if (grey <= 0.0) return {0.0, 0.0, 0.0};
  const double t = std::min({reach(c.r, grey), reach(c.g, grey), reach(c.b, grey)});
  // The limiting component may miss its bound by rounding; clip puts it there.
  return clip({grey + t * (c.r - grey), grey + t * (c.g - grey), grey + t * (c.b - grey)});
}

bool fits(const LinearRgb& c) {
  return clip(c) == c;
}

} // namespace

LinearRgb map_to_gamut(const LinearRgb& color, GamutMapping mapping) {
  if (fits(color)) return color;
  switch (mapping) {
  case GamutMapping::clip:
    return clip(color);
  case GamutMapping::desaturate:
    return desaturate(color);
  }
  return clip(color);
}

} // namespace abbe
