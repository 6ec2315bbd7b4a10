#pragma once

#include "core/scene/scene.h"
#include "io/building/setting_effects.h"
#include "io/scene_language/input_files.h"
#include "io/text/token.h"

#include <filesystem>
#include <string_view>

namespace abbe {

/// Reads a scene file; docs/scene_format.md is its grammar. Libraries are found relative to the
/// scene's folder; without a `lights` or `materials` keyword they are lights.filter and all.mtl
/// there, where these exist.
/// Throws ReadError for anything that cannot be understood. All files that have been read are added
/// to `files`, and the keywords that `warn_of_settings` asks for to `given`, unless they are null.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file, const Warn& warn,
                               InputFiles* files = nullptr, GivenKeywords* given = nullptr);

/// The same from a text in memory. `file` gives the title, the names in messages and the folder; it
/// need not exist.
[[nodiscard]] Scene read_scene_text(std::string_view text, const std::filesystem::path& file,
                                    const Warn& warn, InputFiles* files = nullptr,
                                    GivenKeywords* given = nullptr);

} // namespace abbe
