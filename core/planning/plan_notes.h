#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// Says, for people, what the scene holds and what the plan found to leave out.
void note_content(const Scene& scene, Plan& plan);

} // namespace abbe
