#pragma once

#include "tests/stress/furnace/judgement.h"
#include "tests/stress/tally.h"

namespace abbe::stress {

/// Asks the scene of a seed all questions of a part, and counts the answers. A scene that fails is
/// shrunk, and written to a file of the scene language that the tally's reproduction names.
void try_scene(std::uint64_t seed, Asked asked, Tally& tally);

} // namespace abbe::stress
