#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Beer-Lambert: multiplies bands [first, last) by exp(-absorption * way). An infinite way through
/// an absorbing medium leaves nothing.
void absorb(const MediumPlan& medium, double way, int first, int last, float* throughput);

} // namespace abbe
