// The libraries of a scene, named in it before the first use of a name,
//
//   lights    lights.filter
//   materials all.mtl
//
// or, where none is named, the two files of these names beside the scene.

#include "io/scene_language/read_scene_libraries.h"

#include "io/libraries/read_glass_files.h"
#include "io/libraries/read_library.h"
#include "io/libraries/read_spectrum.h"
#include "io/libraries/standard_lights.h"
#include "io/text/similar_names.h"

#include <fmt/format.h>

#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// What differs between the two kinds of library.
template <class Entry>
struct Kind {
  std::string_view keyword;
  std::string_view default_file;
  std::vector<Entry> (*read)(const fs::path&, const Warn&);
};
constexpr Kind<LightSpectrum> kLights{"lights", "lights.filter", read_lights};
constexpr Kind<LibraryMaterial> kMaterials{"materials", "all.mtl", read_materials};

template <class Entry>
void add_file(SceneLibrary<Entry>& library, const Kind<Entry>& kind, SceneLibraries& libraries,
              const Token& name) {
  if (library.in_use)
    throw ReadError(name.where, fmt::format("{} stands too late", kind.keyword),
                    "a name was looked up before it", "Move it before the first use of a name");
  const fs::path file =
      input_file(libraries.files, name, libraries.folder,
                 {"library", "libraries are found relative to the scene's folder"});
  for (Entry& entry : kind.read(file, {})) {
    if (!library.names.add(entry.name, library.entries.size()))
      throw ReadError(name.where, fmt::format("{} defines \"{}\" again", file.string(), entry.name),
                      fmt::format("it is already in {}", library.files),
                      "Rename or remove one of them");
    library.entries.push_back(std::move(entry));
  }
  library.files += (library.files.empty() ? "" : ", ") + file.string();
}

/// Warns of what is odd about an entry when it is first used, and of nothing else in the file.
template <class Entry>
const Entry* look_up(SceneLibrary<Entry>& library, const Kind<Entry>& kind,
                     SceneLibraries& libraries, std::string_view name, const Warn& warn) {
  const fs::path file = libraries.folder / kind.default_file;
  std::error_code error;
  if (!library.in_use && library.files.empty() && fs::is_regular_file(file, error)) {
    for (Entry& entry : kind.read(file, {})) {
      library.names.add(entry.name, library.entries.size());
      library.entries.push_back(std::move(entry));
    }
    library.files = file.string();
    libraries.files.push_back(file);
  }
  library.in_use = true;
  const auto number = library.names.find(name);
  if (!number) return nullptr;
  Entry& entry = library.entries[*number];
  for (const std::string& remark : std::exchange(entry.remarks, {}))
    warn(remark);
  return &entry;
}

template <class Entry>
std::vector<std::string> names_of(const SceneLibrary<Entry>& library) {
  std::vector<std::string> names;
  for (const Entry& entry : library.entries)
    names.push_back(entry.name);
  return names;
}

template <class Entry>
std::string searched(const SceneLibrary<Entry>& library, const Kind<Entry>& kind) {
  if (!library.files.empty()) return "no such name in " + library.files;
  return fmt::format("there is no {} beside the scene, and no {} keyword", kind.default_file,
                     kind.keyword);
}

} // namespace

void add_lights(SceneLibraries& libraries, const Token& file) {
  add_file(libraries.lights, kLights, libraries, file);
}

void add_materials(SceneLibraries& libraries, const Token& file) {
  add_file(libraries.materials, kMaterials, libraries, file);
}

void add_glasses(SceneLibraries& libraries, const Token& name, const Warn& warn) {
  const fs::path file =
      input_file(libraries.files, name, libraries.folder,
                 {"glass catalogue", "catalogues are found relative to the scene's folder"});
  for (FileGlass& glass : read_agf_text(read_text_file(file), file, warn)) {
    const auto known = libraries.glass_names.find(glass.glass.name);
    if (known) {
      libraries.glasses[*known] = std::move(glass);
      continue;
    }
    (void)libraries.glass_names.add(glass.glass.name, libraries.glasses.size());
    libraries.glasses.push_back(std::move(glass));
  }
}

const FileGlass* look_up_glass(SceneLibraries& libraries, const Token& name) {
  if (const auto known = libraries.glass_names.find(name.text)) return &libraries.glasses[*known];
  if (!is_refractiveindex_file(name.text)) return nullptr;
  add_input(libraries.files, name);
  return &libraries.glasses.emplace_back(read_refractiveindex_glass(name));
}

Curve look_up_light(SceneLibraries& libraries, const Token& name, const Warn& warn) {
  const auto* entry = look_up(libraries.lights, kLights, libraries, name.text, warn);
  if (entry && is_standard_light(name.text) && libraries.warned_names.insert(entry->name).second)
    warn(fmt::format("{}: {} is the light of {}, which hides the built-in light of this name",
                     to_string(name.where), shown(name), libraries.lights.files));
  if (entry) return spectrum(*entry);
  if (is_spectrum_file(name.text)) {
    add_input(libraries.files, name);
    return read_lamp(name, warn);
  }
  if (const auto lamp = standard_light(name)) return *lamp;

  std::vector<std::string> names = names_of(libraries.lights);
  for (std::string& lamp_name : standard_light_names())
    names.push_back(std::move(lamp_name));
  throw ReadError(name.where, "unknown light " + shown(name),
                  searched(libraries.lights, kLights) + "; no such illuminant",
                  did_you_mean(name.text, names, "D65 and A are always there"));
}

const LibraryMaterial& look_up_material(SceneLibraries& libraries, const Token& name,
                                        const Warn& warn) {
  const auto* entry = look_up(libraries.materials, kMaterials, libraries, name.text, warn);
  if (entry) return *entry;
  throw ReadError(name.where, "unknown material " + shown(name),
                  searched(libraries.materials, kMaterials),
                  did_you_mean(name.text, names_of(libraries.materials),
                               "Add it to the material library, or name another one"));
}

} // namespace abbe
