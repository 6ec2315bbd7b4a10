#include "io/commands/develop_command.h"

#include "core/image/develop_colors.h"
#include "core/scene/user_error.h"
#include "io/commands/setting_options.h"
#include "io/console/exit_codes.h"
#include "io/console/terminal.h"
#include "io/images/read_picture.h"
#include "io/outputs/output_effects.h"
#include "io/outputs/write_each.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// A picture as colours, and what its file says of it.
struct Colors {
  PictureHeader header;
  Observer observer = Observer::cie1931_2deg;
  std::vector<Xyz> values;
  std::vector<float> alpha; ///< empty where all is opaque
};

Colors colors_of(const DevelopCommand& command) {
  Colors colors;
  colors.header = read_picture_header(command.file);
  const PictureColors source(colors.header, {command.observer, false}, command.file.string());
  colors.observer = source.observer();
  const PictureRequest request{.bands = source.from_bands(), .alpha = true};
  read_picture_blocks(command.file, request, [&](const PictureValues& block) {
    for (std::size_t pixel = 0; pixel < block.part.pixel_count(); ++pixel)
      colors.values.push_back(source.color(block, pixel));
    colors.alpha.insert(colors.alpha.end(), block.alpha.begin(), block.alpha.end());
  });
  return colors;
}

/// What a rendering says of itself in its EXR, which goes on to what is made of it, but for the
/// observer where another one is told.
Metadata kept_metadata(const Colors& colors, const DevelopCommand& command) {
  if (colors.header.format != "OpenEXR") return {}; // others tell of the screen that was
  Metadata kept = colors.header.of_abbe();
  for (auto& [name, value] : kept)
    if (name == "abbe/observer" && command.observer)
      value = *command.observer == Observer::cie1931_2deg ? "2deg" : "10deg";
  return kept;
}

SceneLinearImage scene_linear_picture(const Colors& colors, const DevelopCommand& command) {
  SceneLinearImage image = scene_linear_of(colors.header.display, colors.header.data, colors.values,
                                           command.output.exr_space);
  for (std::size_t pixel = 0; pixel < colors.alpha.size(); ++pixel)
    image.rgba[4 * pixel + 3] = colors.alpha[pixel];
  image.metadata = kept_metadata(colors, command);
  image.camera = colors.header.camera;
  return image;
}

DisplayImage screen_picture(const Colors& colors, const DevelopCommand& command,
                            const DisplaySettings& settings) {
  const PictureHeader& header = colors.header;
  if (!command.output.ocio)
    return display_of(header.display, header.data, colors.values, settings, colors.observer);
  const OcioTransform ocio(*command.output.ocio);
  return ocio_picture(
      ocio, scene_linear_of(header.display, header.data, colors.values, ocio.space()), settings);
}

} // namespace

void add_options(CLI::App& app, DevelopCommand& command) {
  add_picture(app, "file", command.file, "Picture: EXR, with all bands too, PNG or TIFF");
  add_images(app, command.outputs, "")->required();
  add_observer(app, command.observer);
  add_settings(app, command.display);
  add_output_options(app, command.output);
  app.add_flag("-q,--quiet", command.quiet, "Print warnings and errors only");
}

int run(const DevelopCommand& command) {
  const Outputs outputs{command.outputs, {}, {}};
  check_outputs(outputs, {});
  for (const fs::path& path : command.outputs) {
    std::error_code error; // what does not exist yet is no input
    if (fs::equivalent(path, command.file, error))
      throw UserError(fmt::format("{}: the picture would replace the one that it is made of. Give "
                                  "it another name",
                                  path.string()));
  }
  check_ocio(command.output);
  warn_of_outputs(command.given, outputs, command.output, say_warning);
  const DisplaySettings settings = overridden(DisplaySettings{}, command.display);
  warn_of_adaptation(command.given, outputs, settings, say_warning);
  const Colors colors = colors_of(command);
  if (!colors.header.unknown_tag.empty())
    say_warning(fmt::format("{} is tagged as \"{}\", which is not known; it is read as linear sRGB",
                            command.file.string(), colors.header.unknown_tag));
  SceneLinearImage linear;
  if (std::ranges::any_of(command.outputs, is_scene_linear_extension))
    linear = scene_linear_picture(colors, command);
  DisplayImage display;
  if (!std::ranges::all_of(command.outputs, is_scene_linear_extension)) {
    display = screen_picture(colors, command, settings);
    Metadata metadata = kept_metadata(colors, command);
    metadata.insert(metadata.end(), display.metadata.begin(), display.metadata.end());
    display.metadata = std::move(metadata);
  }
  std::vector<OutputJob> jobs;
  for (const fs::path& path : command.outputs)
    jobs.push_back(
        {path, [&, path] { return write_image(path, linear, display, command.output); }});
  return write_each(jobs, command.quiet) ? 0 : kExitFailure;
}

} // namespace abbe
