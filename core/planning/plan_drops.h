#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// The drops of a medium at the plan's bands, with a phase function for each kind of light that the
/// scene has.
[[nodiscard]] DropsPlan plan_drops(const Scene& scene, const Plan& plan, const Drops& drops);

/// What the drops are and what is left out, for people.
[[nodiscard]] std::string note_of(const Drops& drops);

} // namespace abbe
