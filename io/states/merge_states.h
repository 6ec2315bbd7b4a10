#pragma once

#include "io/states/read_state.h"

#include <span>

namespace abbe {

/// The sum of parts of one rendering, whose films have the same form. A row of all parts is added
/// up before the next one is read, so that only one film is in memory.
[[nodiscard]] RenderState merge_states(std::span<StateReader> parts, const BandPlace& place);

} // namespace abbe
