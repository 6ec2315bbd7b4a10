#pragma once

#include "core/bundles/bundle.h"
#include "core/bundles/statistics.h"
#include "geometry/world.h"

namespace abbe {

/// Takes a bundle straight through the boundary that it has met, one that Plan::unseen knows, and
/// finds what it meets next. No surface is counted; what the way absorbed is the caller's. Whoever
/// passes several one after another hands the same passage on.
void pass_unseen_boundary(Bundle& bundle, const World& world, Passage& passage, RayCounts& counts);

} // namespace abbe
