#pragma once

#include "core/render/render_state.h"
#include "io/states/state_info.h"

#include <filesystem>

namespace abbe {

/// Keeps a state in a file, in the format of docs/state_format.md, row by row. The file's old
/// content stays until the new one is complete. Errors: those of replace_file.
void write_state(const std::filesystem::path& file, const StateInfo& info,
                 const RenderState& state);

} // namespace abbe
