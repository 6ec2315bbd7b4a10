#include "core/integrators/absorption.h"

#include <cmath>

namespace abbe {

void absorb(const MediumPlan& medium, double length, BandSpan<float> throughput) {
  if (!medium.absorbs) return;
  const auto [first, last] = throughput.bands;
  const float* absorption = medium.absorption_per_unit.data();
  const auto distance = static_cast<float>(length);
  if (const auto alike = medium.absorption_per_unit.constant()) {
    const float kept = std::exp(-*alike * distance);
    for (int b = first; b < last; ++b)
      throughput[b] *= kept;
    return;
  }
  for (int b = first; b < last; ++b)
    if (absorption[b] > 0.0f) throughput[b] *= std::exp(-absorption[b] * distance);
}

} // namespace abbe
