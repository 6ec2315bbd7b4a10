#pragma once

#include "io/text/token.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace abbe {

/// The files that a scene has been read from: its own, and all that it names.
using InputFiles = std::vector<std::filesystem::path>;

/// What the messages about a file that a scene names say of it.
struct InputKind {
  std::string_view noun;       ///< "file"
  std::string_view found_from; ///< completes "... are found relative to ..."
};

/// The file that `name` names, found from `folder`, which is added to `files`. Throws ReadError at
/// the name where there is none, or nothing that can be read as a file.
[[nodiscard]] std::filesystem::path input_file(InputFiles& files, const Token& name,
                                               const std::filesystem::path& folder,
                                               const InputKind& kind);

/// The same path for a file that is found from the folder of the file that names it. Nothing is
/// checked: its reader does that.
void add_input(InputFiles& files, const Token& name);

} // namespace abbe
