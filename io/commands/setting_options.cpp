#include "io/commands/setting_options.h"

#include "core/scene/user_error.h"
#include "io/scene_files/read_scene_file.h"
#include "io/text/numbers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <type_traits>

namespace abbe {
namespace {

/// The type of an option's value, as the help shows it.
template <class Row>
std::string type_of(const Row& row) {
  if (!row.type.empty()) return std::string(row.type);
  const std::string words = choice_words(row);
  return words.empty() ? "N" : words;
}

/// What the option does, and its default. A finite range is told here, all other conditions by the
/// error that breaking them brings.
template <class Row, class Settings>
std::string help_of(const Row& row, const Settings& defaults) {
  std::string range, names;
  const auto note = [&](const auto& value) {
    if constexpr (requires { value.range; })
      if (std::isfinite(value.range.highest) && !value.range.open)
        range = fmt::format(", {}", words(value.range));
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, DisplaySpace>)
      names = fmt::format(": {}", fmt::join(color_space_names(), ", "));
    if constexpr (std::is_same_v<Value, DisplayTransfer>)
      names = fmt::format(": {}, or a gamma", fmt::join(transfer_names(), ", "));
  };
  std::visit(note, row.value);
  return fmt::format("{}{} (default {}){}", row.help, range,
                     row.default_words.empty() ? value_text(row, defaults)
                                               : std::string(row.default_words),
                     names);
}

/// Options for all rows of a table of settings.
template <class Row, class Settings>
void add_rows(CLI::App& app, std::span<const Row> table, std::vector<GivenSetting<Row>>& given,
              const Settings& defaults) {
  for (const Row& row : table) {
    if (row.option.empty()) continue;
    const auto give = [&row, &given, defaults](const std::string& text) {
      try {
        Settings tried = defaults;
        set_from_text(row, text, tried);
      } catch (const UserError& error) {
        throw CLI::ValidationError(std::string(row.option), error.what());
      }
      given.push_back({&row, text});
    };
    const std::string option(row.option), help = help_of(row, defaults);
    if (row.flag)
      app.add_flag_callback(option, [give] { give("on"); }, help);
    else
      app.add_option_function<std::string>(option, give, help)->type_name(type_of(row));
  }
}

/// An option of the pictures that takes one of a few words; the help tells which one is set now.
template <class T>
void add_choice(CLI::App& app, const std::string& name, T& target,
                const std::vector<Word<T>>& choices, const std::string& help) {
  std::vector<std::string> names;
  std::string usual;
  for (const auto& [word, value, other] : choices) {
    names.emplace_back(word);
    if (value == target) usual = word;
  }
  app.add_option_function<std::string>(
         name,
         [&target, choices](const std::string& text) {
           for (const Word<T>& choice : choices)
             if (text == choice.word) target = choice.value;
         },
         fmt::format("{} (default {})", help, usual))
      ->check(CLI::IsMember(names).description(""))
      ->type_name(fmt::format("{}", fmt::join(names, "|")));
}

} // namespace

void add_scene(CLI::App& app, std::filesystem::path& scene, Strictness& strictness) {
  app.add_option("scene", scene, "Scene file (" + known_scene_extensions() + ")")
      ->required()
      ->type_name("SCENE");
  app.add_flag_callback(
      "--lenient", [&strictness] { strictness = Strictness::lenient; },
      "Warn of what is not understood of another program's scene, and leave it out");
}

void add_settings(CLI::App& app, SettingsOverride& given) {
  add_rows(app, render_setting_table(), given, RenderSettings{});
}

void add_settings(CLI::App& app, DisplayOverride& given) {
  add_rows(app, display_setting_table(), given, DisplaySettings{});
}

CLI::Option* add_images(CLI::App& app, std::vector<std::filesystem::path>& images,
                        const std::string& usual) {
  return app
      .add_option("-o,--output", images,
                  "Picture to write (" + known_image_extensions() + "); may be repeated" + usual)
      ->allow_extra_args(false)
      ->type_name("FILE");
}

void add_output_options(CLI::App& app, OutputOptions& output) {
  add_choice<SceneLinearSpace>(
      app, "--exr-space", output.exr_space,
      {{"rec709", SceneLinearSpace::rec709},
       {"acescg", SceneLinearSpace::acescg},
       {"aces2065-1", SceneLinearSpace::aces2065_1},
       {"rec2020", SceneLinearSpace::rec2020}},
      "Primaries and white of EXR; the spectral EXR's preview stays rec709");
  add_choice<ExrPixel>(app, "--exr-pixel", output.exr_pixel,
                       {{"half", ExrPixel::half}, {"float", ExrPixel::single}},
                       "Precision of EXR pixels");
  add_choice<ExrTag>(app, "--exr-tag", output.exr_tag,
                     {{"colorInteropID", ExrTag::interop_id},
                      {"chromaticities", ExrTag::chromaticities},
                      {"both", ExrTag::both},
                      {"none", ExrTag::none}},
                     "How EXR says which colours its values are");
  add_choice<TiffDepth>(
      app, "--tiff-depth", output.tiff_depth,
      {{"8", TiffDepth::bits8}, {"16", TiffDepth::bits16}, {"32", TiffDepth::float32}},
      "Bits per TIFF channel; 32 is linear floating point");
  add_choice<int>(app, "--png-depth", output.png_bits, {{"8", 8}, {"16", 16}},
                  "Bits per PNG channel");
  add_choice<IccVersion>(
      app, "--profile", output.profile,
      {{"v4", IccVersion::v4}, {"v2", IccVersion::v2}, {"none", IccVersion::none}},
      "ICC profile of TIFF, and of PNG that is not sRGB");
  const auto ocio = [&output]() -> OcioLook& {
    return output.ocio ? *output.ocio : output.ocio.emplace();
  };
  app.add_option_function<std::string>(
         "--ocio", [ocio](const std::string& file) { ocio().config = file; },
         "TIFF and PNG by a configuration of OpenColorIO, in place of --tone, --gamut, "
         "--white-point "
         "and --adaptation")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--ocio-display", [ocio](const std::string& name) { ocio().display = name; },
         "A display of the configuration (default: its first)")
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--ocio-view", [ocio](const std::string& name) { ocio().view = name; },
         "A view of that display (default: its first)")
      ->type_name("NAME");
  app.add_flag("--full-frame", output.full_frame,
               "Write a crop over the whole frame, black around it");
  app.add_flag("--layer-files", output.layer_files,
               "Write each layer into an EXR of its own, such as NAME.depth.exr");
}

} // namespace abbe
