#include "io/program/command_line.h"

#include "core/scene/user_error.h"
#include "geometry/world/world.h"
#include "io/scene_files/read_scene_file.h"
#include "io/text/numbers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#ifndef ABBE_VERSION
#define ABBE_VERSION "unknown"
#endif

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
void add_settings(CLI::App& app, std::span<const Row> table, std::vector<GivenSetting<Row>>& given,
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

void add_outputs(CLI::App& app, Options& options) {
  app.add_option("-o,--output", options.outputs,
                 "Picture to write (" + known_image_extensions() +
                     "); may be repeated. Default: NAME.exr and NAME.tiff in this folder")
      ->type_name("FILE");
  app.add_option("--spectral", options.spectral_output, "Write all bands into one EXR")
      ->type_name("FILE");
  add_settings(app, display_setting_table(), options.display, DisplaySettings{});
  OutputOptions& output = options.output;
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
  add_choice<TiffDepth>(
      app, "--tiff-depth", output.tiff_depth,
      {{"8", TiffDepth::bits8}, {"16", TiffDepth::bits16}, {"32", TiffDepth::float32}},
      "Bits per TIFF channel; 32 is linear floating point");
  add_choice<int>(app, "--png-depth", output.png_bits, {{"8", 8}, {"16", 16}},
                  "Bits per PNG channel");
  app.add_option_function<std::string>(
         "--limit-memory",
         [&options](const std::string& text) {
           const auto gib = parse_finite(text);
           if (!gib || !(*gib > 0.0) || *gib > 1e6)
             throw CLI::ValidationError("--limit-memory",
                                        "\"" + text + "\" is not a size in GiB above 0");
           options.memory_limit_gib = gib;
         },
         "Do not begin a picture that needs more memory (default: what the machine has left)")
      ->type_name("GIB");
  app.add_flag("-q,--quiet", options.quiet, "Print warnings and errors only");
}

} // namespace

Options parse_command_line(int argc, const char* const* argv) {
  Options options;
  CLI::App app("abbe renders light through glass: every path carries all wavelength bands.",
               "abbe");
  app.set_version_flag("--version",
                       fmt::format("abbe {} (Embree {})", ABBE_VERSION, embree_version()));
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);

  CLI::App* render = app.add_subcommand("render", "Render a scene");
  render->add_option("scene", options.scene_path, "Scene file (" + known_scene_extensions() + ")")
      ->required()
      ->type_name("SCENE");
  add_outputs(*render, options);
  add_settings(*render, render_setting_table(), options.settings, RenderSettings{});

  CLI::App* plan = app.add_subcommand("plan", "Tell what a scene needs and what is left out");
  plan->add_option("scene", options.scene_path, "Scene file (" + known_scene_extensions() + ")")
      ->required()
      ->type_name("SCENE");
  add_settings(*plan, render_setting_table(), options.settings, RenderSettings{});

  CLI::App* list = app.add_subcommand("list", "List what scenes can name");
  list->add_option("what", options.list_what, "glasses, lights, materials or metals")
      ->check(CLI::IsMember({"glasses", "lights", "materials", "metals"}));
  list->add_option("library", options.list_library,
                   "Light or material library to list too (default: those beside the scenes)");
  list->add_option("--plot", options.plot_name,
                   "Draw a light's spectrum, a material's or metal's reflectance, a glass's n")
      ->type_name("NAME");
  list->add_option("--plot-file", options.plot_file, "Draw it into a PNG instead of the terminal")
      ->needs("--plot")
      ->type_name("FILE");

  try {
    app.parse(argc, argv);
    if (list->parsed() && options.list_what.empty() && !options.plot_name)
      throw CLI::RequiredError("what (glasses, lights, materials or metals)");
    if (options.plot_file && options.plot_file->extension() != ".png")
      throw CLI::ValidationError("--plot-file", "the name should end in .png");
  } catch (const CLI::ParseError& error) {
    options.exit_code = app.exit(error) == 0 ? 0 : kExitUsage;
    return options;
  }
  for (const CLI::App* command : {render, plan, list})
    for (const CLI::Option* option : command->get_options())
      if (option->count() > 0) options.given.push_back(option->get_name());
  options.command = render->parsed() ? Command::render
                    : plan->parsed() ? Command::plan
                                     : Command::list;
  return options;
}

} // namespace abbe
