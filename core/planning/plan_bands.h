#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Which bands can carry light to the observer, which of them are carried, and how a path that can
/// follow a few alone divides itself among them. The sources are planned.
void plan_bands(Plan& plan);

/// True when no source gives light that the observer sees.
[[nodiscard]] bool nothing_gives_light(const Plan& plan);

} // namespace abbe
