#pragma once

#include "core/scene/scene.h"
#include "io/building/strictness.h"
#include "io/scene_language/input_files.h"
#include "io/text/read_error.h"

#include <filesystem>
#include <string_view>

namespace abbe {

/// Reads a scene of glTF 2.0, as JSON (.gltf) or with its buffer in one file (.glb).
/// docs/scene_format.md says what is understood; the rest is an error at its JSON pointer, or with
/// Strictness::lenient a warning. All files that are read are added to `files`, unless it is null.
/// Throws ReadError.
[[nodiscard]] Scene read_gltf(const std::filesystem::path& file, const Warn& warn,
                              InputFiles* files, Strictness strictness);

/// The same from the content of a file; `file` is for messages, and other files are found from its
/// folder.
[[nodiscard]] Scene read_gltf_bytes(std::string_view bytes, const std::filesystem::path& file,
                                    const Warn& warn, Strictness strictness);

} // namespace abbe
