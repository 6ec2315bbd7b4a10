#pragma once

#include "core/bundles/bundle.h"

namespace abbe {

/// Takes a bundle straight through what it has met: a boundary that Plan::unseen knows, or a pane.
/// Its ray is untraced then. No surface is counted, and what the medium before the boundary absorbs
/// is the caller's to apply.
void go_straight_on(Bundle& bundle);

} // namespace abbe
