#pragma once

#include "io/states/state_info.h"

#include <filesystem>
#include <span>

namespace abbe {

/// A part of a rendering in its file.
struct KeptPart {
  std::filesystem::path file;
  StateInfo info;
  bool complete = false; ///< all its samples are done
};

/// Throws UserError where these are not all parts of one rendering, each once and complete: it says
/// which do not belong to the first, which come twice, which are incomplete, and which are missing.
void check_parts(std::span<const KeptPart> parts);

} // namespace abbe
