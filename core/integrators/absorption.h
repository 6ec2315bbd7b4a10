#pragma once

#include "core/bands/band_span.h"
#include "core/plan/plan.h"

namespace abbe {

/// Applies Beer and Lambert's law: multiplies the throughput by exp(-absorption * length). An
/// infinite length of an absorbing medium leaves nothing.
void absorb(const MediumPlan& medium, double length, BandSpan<float> throughput);

} // namespace abbe
