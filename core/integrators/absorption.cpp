#include "core/integrators/absorption.h"

#include <cmath>

namespace abbe {

void absorb(const MediumPlan& medium, double way, int first, int last, float* throughput) {
  if (!medium.absorbs) return;
  const float* absorption = medium.absorption_per_unit.data();
  const auto length = static_cast<float>(way);
  if (const auto alike = medium.absorption_per_unit.constant()) {
    const float kept = std::exp(-*alike * length);
    for (int b = first; b < last; ++b)
      throughput[b] *= kept;
    return;
  }
  for (int b = first; b < last; ++b)
    if (absorption[b] > 0.0f) throughput[b] *= std::exp(-absorption[b] * length);
}

} // namespace abbe
