#pragma once

#include "core/bundles/bundle.h"
#include "core/bundles/statistics.h"
#include "geometry/world.h"

namespace abbe {

/// Takes a bundle straight through the boundary that it has met, one that Plan::unseen knows, and
/// finds what it meets next. No surface is counted; what the way absorbed is the caller's.
void pass_unseen_boundary(Bundle& bundle, const World& world, RayCounts& counts);

} // namespace abbe
