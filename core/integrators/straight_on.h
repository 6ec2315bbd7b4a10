#pragma once

#include "core/bundles/bundle.h"

namespace abbe {

/// Takes a bundle straight through the boundary that it has met: one that Plan::unseen knows, or a
/// pane. Its ray is untraced then. No surface is counted, and what the medium before the boundary
/// absorbs is the caller's to apply.
void go_straight_on(Bundle& bundle);

} // namespace abbe
