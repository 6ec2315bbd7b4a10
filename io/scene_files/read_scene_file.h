#pragma once

#include "core/scene/scene.h"
#include "io/building/setting_effects.h"
#include "io/building/strictness.h"
#include "io/scene_language/input_files.h"
#include "io/text/read_error.h"

#include <filesystem>
#include <string>

namespace abbe {

/// Reads a scene in the format that the extension of its name tells, whatever its case. Throws
/// ReadError for an unknown extension, with a list of those that are known, and for all that the
/// format's reader refuses. All files that have been read are added to `files`, and the
/// keywords that `warn_of_settings` asks for to `given`, unless they are null. What a reader of
/// another program's scenes does not understand is an error, unless it is lenient.
[[nodiscard]] Scene read_scene_file(const std::filesystem::path& file, const Warn& warn,
                                    InputFiles* files = nullptr, GivenKeywords* given = nullptr,
                                    Strictness strictness = Strictness::strict);

/// ".sdl, .pbrt, .glb or .gltf", for messages and help; several are joined by commas and "or".
[[nodiscard]] std::string known_scene_extensions();

} // namespace abbe
