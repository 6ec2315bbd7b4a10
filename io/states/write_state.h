#pragma once

#include "core/render/render_state.h"
#include "io/states/state_info.h"

#include <filesystem>
#include <functional>

namespace abbe {

struct FilmRow;

/// Keeps a state in a file, in the format of docs/state_format.md, row by row. The file's old
/// content stays until the new one is complete. Errors: those of replace_file.
void write_state(const std::filesystem::path& file, const StateInfo& info,
                 const RenderState& state);

/// Gives the rows of a film, from the top.
using RowSource = std::function<void(int y, FilmRow& row)>;
/// The same for a state whose film holds only a share of what is to be kept, which `rows` gives.
void write_state(const std::filesystem::path& file, const StateInfo& info, const RenderState& state,
                 const RowSource& rows);

} // namespace abbe
