#pragma once

#include "io/images/write_image.h"
#include "io/settings/setting_text.h"

#include <filesystem>

namespace CLI {
class App;
}

// Options that several commands have.
namespace abbe {

/// The scene, which must be given.
void add_scene(CLI::App& app, std::filesystem::path& scene);

/// An option for each setting of rendering that has one.
void add_settings(CLI::App& app, SettingsOverride& given);

/// An option for each setting of displays that has one.
void add_settings(CLI::App& app, DisplayOverride& given);

/// How the files of images are written.
void add_output_options(CLI::App& app, OutputOptions& output);

} // namespace abbe
