#include "bench/program/command_line.h"

#include "core/scene/user_error.h"
#include "io/settings/setting_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

namespace abbe::bench {
namespace {

constexpr int kExitUsage = 2;

/// Images of rays, bands and plan take this many samples, those of error what the budgets say.
constexpr int kUsualSamples = 4;

/// What is read as words and checked behind the parser.
struct Words {
  std::vector<std::string> axes;
  bool all = false, quick = false;
};

/// An option of the settings, with the values that it has in `abbe render`. What is set is handed
/// to `take` as settings of which only this one counts.
CLI::Option* add_setting(CLI::App& app, const std::string& option, const std::string& help,
                         const std::function<void(const RenderSettings&)>& take) {
  return app
      .add_option_function<std::string>(
          option,
          [option, take](const std::string& text) {
            RenderSettings settings;
            try {
              set_from_text(setting_of_option(option), text, settings);
            } catch (const UserError& error) {
              throw CLI::ValidationError(option, error.what());
            }
            take(settings);
          },
          help)
      ->type_name("N");
}

void add_common(CLI::App& app, Options& options, Words& words) {
  RenderOptions& render = options.render;
  add_setting(app, "--size", "Image size in pixels", [&](const RenderSettings& s) {
    render.width = s.width;
    render.height = s.height;
  })->type_name("WxH");
  add_setting(app, "--crop", "Render only this part of the image", [&](const RenderSettings& s) {
    render.crop = s.crop;
  })->type_name("x0,y0,x1,y1");
  add_setting(app, "--threads", "Threads (default: one per processor)",
              [&](const RenderSettings& s) { render.threads = s.threads; });
  app.add_option("--repeats", render.repeats, "Interleaved repeats of which the median is taken")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_flag("--quick", words.quick,
               "Small images, one repeat: to see that all works, not how fast it is");
  app.add_option("--json", options.json, "Write the results to this file too")->type_name("FILE");
  app.add_option("--html", options.html, "Write tables and plots as one page")->type_name("FILE");
  app.add_option("--plots", options.plots, "Write each plot as SVG into this folder")
      ->check(CLI::ExistingDirectory)
      ->type_name("FOLDER");
}

void add_scenes(CLI::App& app, Options& options, const std::string& usual) {
  app.add_option("scenes", options.scenes,
                 "Scene files, or names of the project's scenes (default: " + usual + ")")
      ->type_name("SCENE");
}

void add_bands(CLI::App& app, Options& options, const std::string& usual) {
  add_setting(app, "--bands", "Wavelength bands (default: " + usual + ")",
              [&](const RenderSettings& s) { options.render.bands = s.bands; });
}

void add_samples(CLI::App& app, Options& options) {
  add_setting(
      app, "--spp", fmt::format("Samples per pixel (default {})", kUsualSamples),
      [&](const RenderSettings& s) { options.render.samples_per_pixel = s.samples_per_pixel; });
}

CLI::App* add_rays(CLI::App& app, Options& options, Words& words) {
  CLI::App* rays =
      app.add_subcommand("rays", "Rays per second by kind, and the same rays through raw Embree");
  add_scenes(*rays, options, "sphere lens prism_view cube");
  rays->add_flag("--all", words.all, "All of the project's scenes")->excludes("scenes");
  add_bands(*rays, options, "1, then 81");
  add_samples(*rays, options);
  return rays;
}

CLI::App* add_band_levels(CLI::App& app, Options& options) {
  CLI::App* bands = app.add_subcommand("bands", "The cost at 1, 3, 9, 27 and 81 bands");
  add_scenes(*bands, options, "sphere lens prism_view");
  add_samples(*bands, options);
  return bands;
}

CLI::App* add_error(CLI::App& app, Options& options) {
  CLI::App* error = app.add_subcommand(
      "error", "Time against error. A small image has wide pixels, and the tolerance is counted in "
               "pixels: for what a large image costs, take a crop of it");
  error->add_option("scene", options.scenes, "Scene file, or name of one of the project's scenes")
      ->required()
      ->expected(1)
      ->type_name("SCENE");
  error
      ->add_option("--vary", options.error.variations,
                   "Settings to compare, such as default, exact, fan=16, fan=8,tolerance=0.5 "
                   "(words: " +
                       variation_words() + ")")
      ->type_name("SETTINGS");
  error
      ->add_option("--budgets", options.error.budgets,
                   "Samples per pixel, with noise the most (default 1 4 16 64)")
      ->check(CLI::Range(1, 1 << 24));
  add_bands(*error, options, "the scene's");
  error
      ->add_option("--reference-spp", options.error.reference_samples,
                   "Samples per pixel of the reference")
      ->check(CLI::Range(1, 1 << 24))
      ->capture_default_str();
  error->add_flag("--band-noise", options.error.band_noise,
                  "Tell the noise of the bands too; keeps them all, which takes time");
  return error;
}

CLI::App* add_plan(CLI::App& app, Options& options) {
  CLI::App* plan = app.add_subcommand(
      "plan", "What each thing is worth that the plan skips, and that no pixel depends on it");
  add_scenes(*plan, options, "sphere_achromatic csg_zoo cornell_thesis metamerism_front");
  add_bands(*plan, options, "the scene's");
  add_samples(*plan, options);
  return plan;
}

CLI::App* add_scaling(CLI::App& app, Options& options, Words& words) {
  CLI::App* scaling = app.add_subcommand(
      "scaling", "Time and memory against threads, image size, samples and primitives");
  scaling
      ->add_option("axes", words.axes,
                   "threads, size, samples, triangles or lenses (default: all of them)")
      ->check(CLI::IsMember({"threads", "size", "samples", "triangles", "lenses"}).description(""))
      ->type_name("AXIS");
  scaling
      ->add_option("--scene", options.scenes, "Scene for threads, size and samples (default: lens)")
      ->expected(1)
      ->type_name("SCENE");
  scaling
      ->add_option("--most-triangles", options.scaling.most_triangles,
                   "Triangles, in powers of ten from 10 up to this")
      ->check(CLI::Range(10, 100'000'000))
      ->capture_default_str();
  scaling
      ->add_option("--most-lenses", options.scaling.most_lenses,
                   "Lenses, in powers of ten up to this")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  add_bands(*scaling, options, "the scene's; 1 for triangles and lenses");
  add_samples(*scaling, options);
  return scaling;
}

CLI::App* add_compare(CLI::App& app, Options& options) {
  CLI::App* compare = app.add_subcommand(
      "compare", "Two --json files: what became slower or faster, and what is noise. Exit code 1 "
                 "when something became slower");
  compare->add_option("reports", options.reports, "The files of before and after")
      ->required()
      ->expected(2)
      ->check(CLI::ExistingFile)
      ->type_name("BEFORE AFTER");
  compare
      ->add_option("--margin", options.margin,
                   "The share by which two runs may differ without a cause")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  return compare;
}

Axis axis_of(const std::string& word) {
  const std::map<std::string, Axis> axes{{"threads", Axis::threads},
                                         {"size", Axis::size},
                                         {"samples", Axis::samples},
                                         {"triangles", Axis::triangles},
                                         {"lenses", Axis::lenses}};
  return axes.at(word);
}

std::vector<std::filesystem::path> usual_scenes(Measurement measurement) {
  switch (measurement) {
  case Measurement::rays:
    return {"sphere", "lens", "prism_view", "cube"};
  case Measurement::bands:
    return {"sphere", "lens", "prism_view"};
  case Measurement::plan:
    return {"sphere_achromatic", "csg_zoo", "cornell_thesis", "metamerism_front"};
  case Measurement::scaling:
    return {"lens"};
  case Measurement::error:
  case Measurement::compare:
  case Measurement::done:
    break;
  }
  return {};
}

/// Caps everything that takes long.
void make_quick(Options& options) {
  RenderOptions& render = options.render;
  render.repeats = 1;
  render.samples_per_pixel = 1;
  for (std::optional<int>* side : {&render.width, &render.height})
    *side = std::min(**side, 32);
  for (int& samples : options.error.budgets)
    samples = std::min(samples, 4);
  options.error.reference_samples = std::min(options.error.reference_samples, 8);
  options.scaling.most_triangles = std::min<std::size_t>(options.scaling.most_triangles, 1000);
  options.scaling.most_lenses = std::min<std::size_t>(options.scaling.most_lenses, 100);
}

/// What is left open by the user.
void fill_in(Options& options, const Words& words) {
  RenderOptions& render = options.render;
  const bool long_ones =
      options.measurement == Measurement::error || options.measurement == Measurement::scaling;
  const int side = long_ones ? 128 : 256;
  if (!render.width) render.width = render.height = side;
  if (!render.samples_per_pixel) render.samples_per_pixel = kUsualSamples;
  if (words.quick) make_quick(options);
  auto& budgets = options.error.budgets;
  std::sort(budgets.begin(), budgets.end());
  budgets.erase(std::unique(budgets.begin(), budgets.end()), budgets.end());
  if (!words.axes.empty()) {
    options.scaling.axes.clear();
    for (const std::string& word : words.axes)
      options.scaling.axes.push_back(axis_of(word));
  }
  options.error.render = options.scaling.render = render;
  if (words.all) options.scenes = all_scenes();
  if (options.scenes.empty()) options.scenes = usual_scenes(options.measurement);
}

} // namespace

Options parse_command_line(int argc, const char* const* argv) {
  Options options;
  Words words;
  CLI::App app("Measures abbe. Seconds are processor time summed over the threads.", "abbe bench");
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  const std::pair<Measurement, CLI::App*> commands[] = {
      {Measurement::rays, add_rays(app, options, words)},
      {Measurement::bands, add_band_levels(app, options)},
      {Measurement::error, add_error(app, options)},
      {Measurement::plan, add_plan(app, options)},
      {Measurement::scaling, add_scaling(app, options, words)}};
  for (const auto& [measurement, command] : commands)
    add_common(*command, options, words);
  const CLI::App* compare = add_compare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& mistake) {
    options.exit_code = app.exit(mistake) == 0 ? 0 : kExitUsage;
    return options;
  }
  for (const auto& [measurement, command] : commands)
    if (command->parsed()) options.measurement = measurement;
  if (compare->parsed()) options.measurement = Measurement::compare;
  fill_in(options, words);
  return options;
}

} // namespace abbe::bench
