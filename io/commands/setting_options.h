#pragma once

#include "io/building/strictness.h"
#include "io/images/write_image.h"
#include "io/settings/setting_text.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

// Options that several commands have.
namespace abbe {

/// The scene, which must be given, and how strictly it is read.
void add_scene(CLI::App& app, std::filesystem::path& scene, Strictness& strictness);

/// An option for each setting of rendering that has one.
void add_settings(CLI::App& app, SettingsOverride& given);

/// An option for each setting of displays that has one.
void add_settings(CLI::App& app, DisplayOverride& given);

/// The files of images, one by one; what follows a file may be a scene or the like.
CLI::Option* add_images(CLI::App& app, std::vector<std::filesystem::path>& images,
                        const std::string& usual);

/// How the files of images are written.
void add_output_options(CLI::App& app, OutputOptions& output);

} // namespace abbe
