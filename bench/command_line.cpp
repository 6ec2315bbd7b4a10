#include "bench/command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace abbe::bench {
namespace {

constexpr int kExitUsage = 2;

void add_common(CLI::App& app, Options& options, std::vector<int>& size, std::vector<int>& crop) {
  RenderOptions& render = options.error.render;
  app.add_option("--size", size, "Image size in pixels")
      ->delimiter('x')
      ->expected(2)
      ->check(CLI::Range(1, 65536))
      ->type_name("WxH");
  app.add_option("--crop", crop, "Render only this part of the image")
      ->delimiter(',')
      ->expected(4)
      ->type_name("x0,y0,x1,y1");
  app.add_option("--threads", render.threads, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 4096));
  app.add_option("--repeats", render.repeats, "Interleaved repeats of which the median is taken")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--json", options.json, "Write the results to this file too")->type_name("FILE");
}

void add_scenes(CLI::App& app, Options& options, const std::string& usual) {
  app.add_option("scenes", options.scenes,
                 "Scene files, or names of the project's scenes (default: " + usual + ")")
      ->type_name("SCENE");
}

} // namespace

Options parse_command_line(int argc, const char* const* argv) {
  Options options;
  RenderOptions& render = options.error.render;
  std::vector<int> size, crop;
  CLI::App app("Measures abbe. Seconds are processor time summed over the threads.", "abbe bench");
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);

  CLI::App* rays =
      app.add_subcommand("rays", "Rays per second by kind, and the same rays through raw Embree");
  add_scenes(*rays, options, "sphere lens prism_a cube");
  rays->add_option("--bands", render.bands, "Wavelength bands (default: 1, then 81)")
      ->check(CLI::Range(1, 405));
  rays->add_option("--spp", render.samples_per_pixel, "Samples per pixel (default 4)")
      ->check(CLI::Range(1, 1 << 24));

  CLI::App* bands = app.add_subcommand("bands", "The cost at 1, 3, 9, 27 and 81 bands");
  add_scenes(*bands, options, "sphere lens prism_a");
  bands->add_option("--spp", render.samples_per_pixel, "Samples per pixel (default 4)")
      ->check(CLI::Range(1, 1 << 24));

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
                   "(words: fan, tolerance, cutoff, bands, noise, lightpaths, exact, jitter, "
                   "integrator, caustics)")
      ->type_name("SETTINGS");
  error
      ->add_option("--budgets", options.error.budgets,
                   "Samples per pixel, with noise the most (default 1 4 16 64)")
      ->check(CLI::Range(1, 1 << 24));
  error->add_option("--bands", render.bands, "Wavelength bands (default: the scene's)")
      ->check(CLI::Range(1, 405));
  error
      ->add_option("--reference-spp", options.error.reference_samples,
                   "Samples per pixel of the reference")
      ->check(CLI::Range(1, 1 << 24))
      ->capture_default_str();

  error->add_flag("--band-noise", options.error.band_noise,
                  "Tell the noise of the bands too; keeps them all, which takes time");

  for (CLI::App* command : {rays, bands, error})
    add_common(*command, options, size, crop);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& mistake) {
    options.exit_code = app.exit(mistake) == 0 ? 0 : kExitUsage;
    return options;
  }
  options.measurement = rays->parsed()    ? Measurement::rays
                        : bands->parsed() ? Measurement::bands
                                          : Measurement::error;
  const int side = error->parsed() ? 128 : 256;
  render.width = size.empty() ? side : size[0];
  render.height = size.empty() ? side : size[1];
  if (!crop.empty()) render.crop = PixelWindow{crop[0], crop[1], crop[2], crop[3]};
  if (!render.samples_per_pixel) render.samples_per_pixel = 4;
  std::sort(options.error.budgets.begin(), options.error.budgets.end());
  if (options.scenes.empty()) {
    options.scenes = {"sphere", "lens", "prism_a"};
    if (rays->parsed()) options.scenes.emplace_back("cube");
  }
  return options;
}

} // namespace abbe::bench
