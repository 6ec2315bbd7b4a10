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

LinearRgb desaturate(const LinearRgb& c, const Vector3& weights) {
  const double grey = weights[0] * c.r + weights[1] * c.g + weights[2] * c.b;
  if (grey >= 1.0) return {1.0, 1.0, 1.0};
  if (grey <= 0.0) return {0.0, 0.0, 0.0};
  const double t = std::min({reach(c.r, grey), reach(c.g, grey), reach(c.b, grey)});
  // The limiting component may miss its bound by rounding; clip puts it there.
  return clip({grey + t * (c.r - grey), grey + t * (c.g - grey), grey + t * (c.b - grey)});
}

LinearRgb scale(const LinearRgb& c) {
  const double low = std::min({0.0, c.r, c.g, c.b});
  const double range = std::max({1.0, c.r, c.g, c.b}) - low;
  return clip({(c.r - low) / range, (c.g - low) / range, (c.b - low) / range});
}

bool fits(const LinearRgb& c) {
  return clip(c) == c;
}

} // namespace

LinearRgb map_to_gamut(const LinearRgb& color, GamutMapping mapping,
                       const Vector3& luminance_weights) {
  if (fits(color)) return color;
  switch (mapping) {
  case GamutMapping::clip:
    return clip(color);
  case GamutMapping::desaturate:
    return desaturate(color, luminance_weights);
  case GamutMapping::scale:
    return scale(color);
  case GamutMapping::none:
    return color;
  }
  return clip(color);
}

} // namespace abbe
