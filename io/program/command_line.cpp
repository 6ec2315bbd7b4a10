#include "io/program/command_line.h"

#include "geometry/world.h"
#include "io/text/read_arguments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <map>

#ifndef ABBE_VERSION
#define ABBE_VERSION "unknown"
#endif

namespace abbe {
namespace {

const std::map<std::string, SceneLinearSpace> kExrSpaces{
    {"rec709", SceneLinearSpace::rec709},
    {"acescg", SceneLinearSpace::acescg},
    {"aces2065-1", SceneLinearSpace::aces2065_1},
    {"rec2020", SceneLinearSpace::rec2020}};

template <class T>
void replace(T& setting, const std::optional<T>& given) {
  if (given) setting = *given;
}

/// Whole numbers separated by one character; throws CLI::ValidationError for anything else.
std::vector<int> whole_numbers(const std::string& text, char separator, std::size_t count,
                               const std::string& right) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    int value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) break;
    numbers.push_back(value);
    at = next;
    if (at == end || *at != separator) break;
    ++at;
  }
  if (at != end || numbers.size() != count)
    throw CLI::ValidationError(fmt::format("\"{}\" is not {}", text, right));
  return numbers;
}

/// Checks a number and its limits. (CLI::Range lets "nan" pass.)
CLI::Validator number_from(double lowest, double highest) {
  return {[=](std::string& text) {
            const auto value = parse_finite(text);
            if (value && *value >= lowest && *value <= highest) return std::string();
            return fmt::format("\"{}\" is not a number from {} to {}", text, lowest, highest);
          },
          ""};
}

/// (CLI11 takes "-1" for a large number.)
std::uint64_t seed_from(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || stop != end)
    throw CLI::ValidationError(
        fmt::format("\"{}\" is not a seed: a whole number from 0 to 2^64 - 1", text));
  return seed;
}

/// An option that takes one of a few words.
template <class T>
void add_choice(CLI::App& app, const std::string& names, std::optional<T>& target,
                const std::map<std::string, T>& choices, const std::string& help) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices)
    words.push_back(word);
  app.add_option_function<std::string>(
         names, [&target, choices](const std::string& word) { target = choices.at(word); }, help)
      ->check(CLI::IsMember(words).description(""))
      ->type_name(fmt::format("{}", fmt::join(words, "|")));
}

void add_settings(CLI::App& app, SettingsOverride& s) {
  const std::map<std::string, bool> on_off{{"on", true}, {"off", false}};
  app.add_option("--bands", s.bands, "Wavelength bands, 1 to 405 (default 81)")
      ->check(CLI::Range(1, 405));
  add_choice<Observer>(app, "--observer", s.observer,
                       {{"2", Observer::cie1931_2deg}, {"10", Observer::cie1964_10deg}},
                       "CIE observer: 1931 of 2 degrees or 1964 of 10 degrees (default 2)");
  app.add_option("--spp", s.samples_per_pixel,
                 "Samples per pixel (default 16), with --noise or --time the most (4096)")
      ->check(CLI::Range(1, 1 << 24));
  app.add_option(
         "--noise", s.noise,
         "Sample each tile until its estimated relative error is at most this, such as 0.05 "
         "(default 0: all samples)")
      ->check(number_from(0.0, 1.0));
  add_choice<AdaptiveSampling>(
      app, "--adaptive", s.adaptive,
      {{"on", AdaptiveSampling::on},
       {"off", AdaptiveSampling::off},
       {"automatic", AdaptiveSampling::automatic}},
      "Pixels get the more samples the noisier they are, --spp in the mean (default automatic: "
      "with 8 or more, unless --noise)");
  app.add_option("--time", s.seconds,
                 "End after so many seconds of rendering; the same bytes are not promised then")
      ->check(number_from(0.0, 1e9))
      ->type_name("SECONDS");
  app.add_flag_callback(
      "--errors", [&s] { s.keep_errors = true; },
      "Write the channels samples and error.Y into EXR, as --noise and --time do");
  app.add_option_function<std::string>(
         "--size",
         [&s](const std::string& text) {
           const auto n = whole_numbers(text, 'x', 2, "a size such as 640x480");
           if (n[0] < 1 || n[1] < 1 || n[0] > 65536 || n[1] > 65536)
             throw CLI::ValidationError("an image has 1 to 65536 pixels per side");
           s.width = n[0];
           s.height = n[1];
         },
         "Image size in pixels (default 512x512)")
      ->type_name("WxH");
  app.add_option_function<std::string>(
         "--crop",
         [&s](const std::string& text) {
           const auto n = whole_numbers(text, ',', 4, "a crop x0,y0,x1,y1");
           s.crop = PixelWindow{n[0], n[1], n[2], n[3]};
         },
         "Render only pixels x0 <= x < x1, y0 <= y < y1, counted from the upper left corner")
      ->type_name("x0,y0,x1,y1");
  add_choice<Integrator>(app, "--integrator", s.integrator,
                         {{"whitted", Integrator::whitted}, {"path", Integrator::path}},
                         "Model of light transport");
  app.add_option("--depth", s.max_depth,
                 "How often a path may be reflected or refracted (default 16)")
      ->check(CLI::Range(0, 1 << 20));
  app.add_option("--cutoff", s.min_throughput,
                 "Branches that carry less than this in every band are dropped (default 0.001)")
      ->check(number_from(0.0, 1.0));
  add_choice<ShadowRule>(
      app, "--shadows", s.shadows,
      {{"none", ShadowRule::none},
       {"opaque", ShadowRule::opaque},
       {"attenuated", ShadowRule::attenuated}},
      "What glass does to shadow rays (default: attenuated with whitted, opaque with path)");
  add_choice<Caustics>(
      app, "--caustics", s.caustics,
      {{"on", Caustics::on}, {"off", Caustics::off}, {"automatic", Caustics::automatic}},
      "Light that comes by mirrors and glass, with path (default automatic)");
  app.add_option("--light-paths", s.light_paths, "Light paths per camera sample (default 1)")
      ->check(number_from(0.0, 1e6));
  app.add_option("--photon-radius", s.photon_radius,
                 "Of the first pass, in scene units; 0: by the scene's size (default)")
      ->check(number_from(0.0, 1e30));
  add_choice<PixelFilter>(
      app, "--filter", s.filter,
      {{"box", PixelFilter::box}, {"tent", PixelFilter::tent}, {"gaussian", PixelFilter::gaussian}},
      "Pixel filter (default gaussian)");
  app.add_flag_callback(
      "--exact", [&s] { s.exact = true; }, "Every band its own ray: no tolerance, no roulette");
  app.add_option("--tolerance", s.tolerance_pixels,
                 "Bands share a ray while it strays less than this many pixels (default 0.25)")
      ->check(number_from(0.0, 65536.0));
  app.add_option("--fan", s.max_fan, "Most sub-bundles that one path follows (default 4)")
      ->check(CLI::Range(1, 405));
  add_choice<bool>(app, "--jitter", s.jitter, on_off, "Draw wavelengths inside bands (default on)");
  app.add_option_function<std::string>(
         "--seed", [&s](const std::string& text) { s.seed = seed_from(text); },
         "Seed of the random numbers (default 0)")
      ->type_name("UINT");
  app.add_option("--threads", s.threads, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 4096));
  add_choice<bool>(app, "--skip", s.skip, on_off,
                   "Leave out what the plan finds to be without effect (default on)");
  add_choice<Tracing>(app, "--tracing", s.tracing,
                      {{"single", Tracing::single}, {"packets", Tracing::packets}},
                      "How rays are handed to Embree; the picture is the same (default packets)");
}

/// A reader of words that may fail, as an option.
template <class T, class Read>
void add_word(CLI::App& app, const std::string& name, const std::string& type, T& target, Read read,
              const std::string& right, const std::string& help) {
  app.add_option_function<std::string>(
         name,
         [&target, read, right](const std::string& text) {
           auto value = read(text);
           if (!value) throw CLI::ValidationError(fmt::format("\"{}\" is not {}", text, right));
           target = std::move(*value);
         },
         help)
      ->type_name(type);
}

void add_display(CLI::App& app, DisplayOverride& display) {
  app.add_option("--exposure", display.exposure_ev, "Exposure of TIFF and PNG in stops (default 0)")
      ->check(number_from(-64.0, 64.0))
      ->type_name("EV");
  add_choice<GamutMapping>(app, "--gamut", display.gamut,
                           {{"clip", GamutMapping::clip},
                            {"scale", GamutMapping::scale},
                            {"desaturate", GamutMapping::desaturate}},
                           "How TIFF and PNG treat colours that the display cannot show (default "
                           "desaturate)");
  add_word(app, "--display", "NAME", display.space, find_color_space,
           fmt::format("a display; these are: {}", fmt::join(color_space_names(), ", ")),
           fmt::format("Colour space of TIFF and PNG (default srgb): {}",
                       fmt::join(color_space_names(), ", ")));
  add_word(app, "--transfer", "NAME|GAMMA", display.transfer, find_transfer,
           fmt::format("a transfer function; these are: {}, or a gamma from 0.1 to 10",
                       fmt::join(transfer_names(), ", ")),
           fmt::format("Transfer function of TIFF and PNG (default: that of the display): {}, or a "
                       "gamma",
                       fmt::join(transfer_names(), ", ")));
  add_word(app, "--white-point", "NAME|x,y", display.white_point, parse_white_point,
           "a white point: an illuminant such as D50, x,y such as 0.3457,0.3585, or none",
           "Light that TIFF and PNG show as white: an illuminant, or x,y (default none: what is, "
           "is shown)");
}

void add_outputs(CLI::App& app, Options& options) {
  app.add_option("-o,--output", options.outputs,
                 "Picture to write (" + known_image_extensions() +
                     "); may be repeated. Default: NAME.exr and NAME.tiff in this folder")
      ->type_name("FILE");
  app.add_option("--spectral", options.spectral_output, "Write all bands into one EXR")
      ->type_name("FILE");
  add_display(app, options.display);
  app.add_option_function<std::string>(
         "--exr-space",
         [&options](const std::string& word) { options.output.exr_space = kExrSpaces.at(word); },
         "Primaries and white of EXR (default rec709); the spectral EXR's preview stays rec709")
      ->check(CLI::IsMember({"rec709", "acescg", "aces2065-1", "rec2020"}).description(""))
      ->type_name("rec709|acescg|aces2065-1|rec2020");
  app.add_option_function<std::string>(
         "--exr-pixel",
         [&options](const std::string& word) {
           options.output.exr_pixel = word == "half" ? ExrPixel::half : ExrPixel::single;
         },
         "Precision of EXR pixels (default half)")
      ->check(CLI::IsMember({"half", "float"}).description(""))
      ->type_name("half|float");
  app.add_option_function<std::string>(
         "--tiff-depth",
         [&options](const std::string& word) {
           options.output.tiff_depth = word == "8"    ? TiffDepth::bits8
                                       : word == "16" ? TiffDepth::bits16
                                                      : TiffDepth::float32;
         },
         "Bits per TIFF channel; 32 is linear floating point (default 4)")
      ->check(CLI::IsMember({"8", "16", "32"}).description(""))
      ->type_name("8|16|32");
  app.add_option("--png-depth", options.output.png_bits, "Bits per PNG channel (default 4)")
      ->check(CLI::IsMember({8, 16}).description(""))
      ->type_name("8|16");
  app.add_flag("-q,--quiet", options.quiet, "Print warnings and errors only");
}

} // namespace

RenderSettings overridden(RenderSettings s, const SettingsOverride& given) {
  replace(s.width, given.width);
  replace(s.height, given.height);
  replace(s.bands, given.bands);
  replace(s.samples_per_pixel, given.samples_per_pixel);
  replace(s.noise, given.noise);
  replace(s.seconds, given.seconds);
  replace(s.adaptive, given.adaptive);
  replace(s.keep_errors, given.keep_errors);
  replace(s.max_depth, given.max_depth);
  replace(s.max_fan, given.max_fan);
  replace(s.threads, given.threads);
  replace(s.seed, given.seed);
  replace(s.min_throughput, given.min_throughput);
  replace(s.tolerance_pixels, given.tolerance_pixels);
  replace(s.integrator, given.integrator);
  replace(s.filter, given.filter);
  replace(s.shadows, given.shadows);
  replace(s.caustics, given.caustics);
  replace(s.light_paths, given.light_paths);
  replace(s.photon_radius, given.photon_radius);
  replace(s.exact, given.exact);
  replace(s.jitter, given.jitter);
  replace(s.tracing, given.tracing);
  replace(s.observer, given.observer);
  if (given.skip) s.skip = *given.skip;
  if (given.crop) s.crop = given.crop;
  return s;
}

DisplaySettings overridden(DisplaySettings s, const DisplayOverride& given) {
  replace(s.exposure_ev, given.exposure_ev);
  replace(s.gamut, given.gamut);
  replace(s.space, given.space);
  if (given.transfer) s.transfer = given.transfer;
  replace(s.white_point, given.white_point);
  return s;
}

Options parse_command_line(int argc, const char* const* argv) {
  Options options;
  CLI::App app("abbe renders light through glass: every path carries all wavelength bands.",
               "abbe");
  app.set_version_flag("--version",
                       fmt::format("abbe {} (Embree {})", ABBE_VERSION, embree_version()));
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);

  CLI::App* render = app.add_subcommand("render", "Render a scene");
  render->add_option("scene", options.scene_path, "Scene file (*.sdl)")
      ->required()
      ->type_name("SCENE");
  add_outputs(*render, options);
  add_settings(*render, options.settings);

  CLI::App* plan = app.add_subcommand("plan", "Tell what a scene needs and what is left out");
  plan->add_option("scene", options.scene_path, "Scene file (*.sdl)")
      ->required()
      ->type_name("SCENE");
  add_settings(*plan, options.settings);

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
  options.command = render->parsed() ? Command::render
                    : plan->parsed() ? Command::plan
                                     : Command::list;
  return options;
}

} // namespace abbe
