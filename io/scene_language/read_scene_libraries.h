#pragma once

#include "io/libraries/read_glass_files.h"
#include "io/libraries/read_lights.h"
#include "io/libraries/read_materials.h"
#include "io/scene_language/input_files.h"
#include "io/text/name_index.h"
#include "io/text/token.h"

#include <deque>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// The entries of a scene's libraries of one kind.
template <class Entry>
struct SceneLibrary {
  std::vector<Entry> entries;
  NameIndex names;     ///< of the entries
  std::string files;   ///< for messages
  bool in_use = false; ///< a name has been looked up; no more files can be named
};

/// The light and material libraries of a scene. Files are found relative to `folder`.
struct SceneLibraries {
  std::filesystem::path folder;
  InputFiles files; ///< of all libraries that have been read
  SceneLibrary<LightSpectrum> lights;
  SceneLibrary<LibraryMaterial> materials;
  std::set<std::string> warned_names; ///< lights that hide a built-in one
  std::deque<FileGlass> glasses;      ///< of catalogues and files; they stay where they are
  NameIndex glass_names;              ///< the places in it
};

/// Adds the entries of the file that `file` names.
void add_lights(SceneLibraries& libraries, const Token& file);
void add_materials(SceneLibraries& libraries, const Token& file);

/// Adds the glasses of the catalogue that `file` names. A later one of the same name counts.
void add_glasses(SceneLibraries& libraries, const Token& file, const Warn& warn);

/// The glass of a catalogue that the scene has named, or of a file of refractiveindex.info; null
/// where the name is neither.
[[nodiscard]] const FileGlass* look_up_glass(SceneLibraries& libraries, const Token& name);

/// The spectrum of a library's light, else of a built-in one. Throws ReadError with similar
/// names when there is neither.
[[nodiscard]] Curve look_up_light(SceneLibraries& libraries, const Token& name, const Warn& warn);

/// The material of a library. Throws ReadError with similar names when there is none.
[[nodiscard]] const LibraryMaterial& look_up_material(SceneLibraries& libraries, const Token& name,
                                                      const Warn& warn);

} // namespace abbe
