#include "io/commands/relight_command.h"

#include "core/image/relight.h"
#include "core/scene/user_error.h"
#include "io/console/exit_codes.h"
#include "io/console/terminal.h"
#include "io/images/read_picture.h"
#include "io/images/write_image.h"
#include "io/libraries/read_lights.h"
#include "io/libraries/standard_lights.h"
#include "io/outputs/check_outputs.h"
#include "io/outputs/write_each.h"
#include "io/text/numbers.h"
#include "io/text/similar_names.h"
#include "spectral/observer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// The bands of a rendering that a file has. Throws UserError where they are others.
BandGrid grid_of(const fs::path& file, const PictureHeader& cube) {
  const std::vector<double>& nm = cube.wavelengths_nm;
  const BandGrid grid(std::clamp(static_cast<int>(nm.size()), 1, BandGrid::kMaxCount));
  bool same = nm.size() == static_cast<std::size_t>(grid.count());
  for (std::size_t b = 0; same && b < nm.size(); ++b)
    same = std::abs(nm[b] - grid.center_nm(static_cast<int>(b))) < 1e-5;
  if (!same)
    throw UserError(fmt::format("{}: its bands are not those of a rendering", file.string()));
  return grid;
}

/// A lamp that a group of lights is to have.
struct GivenLamp {
  std::string name;
  Curve spectrum;
  bool used = false;
};

Curve lamp_of(const RelightCommand& command, const std::string& name) {
  if (command.light_library)
    for (const LightSpectrum& light : read_lights(*command.light_library, say_warning))
      if (light.name == name) return spectrum(light);
  if (const auto light = standard_light({TokenKind::word, name, {}})) return *light;
  throw UserError(fmt::format("unknown lamp \"{}\". {}", name,
                              did_you_mean(name, standard_light_names(),
                                           "abbe list lights has those that are always there; "
                                           "--lights names a library")));
}

/// By the group: NAME=LAMP or NAME=LAMP,STRENGTH.
std::map<std::string, GivenLamp> given_lamps(const RelightCommand& command) {
  std::map<std::string, GivenLamp> lamps;
  for (const std::string& text : command.lights) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0)
      throw UserError(fmt::format("--light {}: give NAME=LAMP or NAME=LAMP,STRENGTH, such as "
                                  "key=FL11,0.5",
                                  text));
    const std::string lamp = text.substr(equals + 1), name = lamp.substr(0, lamp.rfind(','));
    double strength = 1.0;
    if (name.size() < lamp.size()) {
      const auto given = parse_finite(std::string_view(lamp).substr(name.size() + 1));
      if (!given || *given < 0.0)
        throw UserError(fmt::format("--light {}: \"{}\" is not a strength of 0 or more", text,
                                    lamp.substr(name.size() + 1)));
      strength = *given;
    }
    const std::string group = text.substr(0, equals);
    if (!lamps.emplace(group, GivenLamp{name, lamp_of(command, name).scaled(strength)}).second)
      throw UserError(fmt::format("--light {} is given twice", group));
  }
  return lamps;
}

/// The sum of all cubes under their lamps.
class Relit {
public:
  explicit Relit(std::map<std::string, GivenLamp> lamps) : lamps_(std::move(lamps)) {}

  void add(const fs::path& file);
  /// Throws UserError for a lamp whose group is in no cube.
  void check_used() const;
  [[nodiscard]] SceneLinearImage image() const;
  /// How much noise the changes add, a note for each lamp.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

private:
  Lamp begin(const fs::path& file, const PictureHeader& cube);

  std::map<std::string, GivenLamp> lamps_;
  std::map<std::string, fs::path> groups_; ///< that have been added, with their files
  std::optional<PictureHeader> first_;
  std::vector<Xyz> colors_;
  std::vector<float> alpha_;
  Metadata metadata_;
  std::vector<std::string> notes_;
};

Lamp Relit::begin(const fs::path& file, const PictureHeader& cube) {
  const std::string group = cube.text("abbe/lightGroup");
  if (group.empty())
    throw UserError(fmt::format("{}: this is not the light of one group of lights, as "
                                "render --relightable writes it",
                                file.string()));
  if (!groups_.emplace(group, file).second)
    throw UserError(fmt::format("{} and {} are both the light of {}", groups_[group].string(),
                                file.string(), group));
  const auto lamp = lamps_.find(group);
  if (lamp == lamps_.end())
    throw UserError(fmt::format("{}: say which lamp {} is to have, such as --light {}=D65, or "
                                "--light {}=E,0 for none",
                                file.string(), group, group, group));
  lamp->second.used = true;
  if (!first_) {
    first_ = cube;
    colors_.assign(cube.data.pixel_count(), {0.0, 0.0, 0.0});
    alpha_.resize(cube.data.pixel_count());
  }
  if (cube.data != first_->data || cube.display != first_->display ||
      cube.wavelengths_nm != first_->wavelengths_nm ||
      cube.text("abbe/observer") != first_->text("abbe/observer"))
    throw UserError(fmt::format("{}: its pixels, bands or observer are not those of {}",
                                file.string(), groups_.begin()->second.string()));
  const BandGrid grid = grid_of(file, cube);
  if (!lamp->second.spectrum.spectral_lines().empty())
    say_warning(fmt::format("{} is made of lines. Glass has bent them as light anywhere in their "
                            "bands, which are {:.3g} nm wide",
                            lamp->second.name, grid.width_nm()));
  metadata_.emplace_back("abbe/lamp/" + group, lamp->second.name);
  const bool wide = cube.text("abbe/observer") == "10deg";
  const Observer observer = wide ? Observer::cie1964_10deg : Observer::cie1931_2deg;
  const double noise = noise_of_change(grid, lamp->second.spectrum, observer);
  metadata_.emplace_back("abbe/lampNoise/" + group, fmt::format("{:.3g}", noise));
  notes_.push_back(fmt::format(
      "light of {} under {}: where glass parts its bands, it has up to {:.3g} times the noise that "
      "a rendering with this lamp would have",
      group, lamp->second.name, noise));
  return {grid, lamp->second.spectrum, observer};
}

void Relit::add(const fs::path& file) {
  const Lamp lamp = begin(file, read_picture_header(file));
  std::size_t pixel = 0;
  const auto add_block = [&](const PictureValues& block) {
    const std::size_t bands = block.header.wavelengths_nm.size();
    for (std::size_t i = 0; i < block.part.pixel_count(); ++i, ++pixel) {
      alpha_[pixel] = block.alpha.empty() ? 1.0f : block.alpha[i];
      colors_[pixel] += lamp.color(std::span(block.bands).subspan(i * bands, bands));
    }
  };
  read_picture_blocks(file, {.bands = true, .alpha = true}, add_block);
}

void Relit::check_used() const {
  for (const auto& [group, lamp] : lamps_)
    if (!lamp.used)
      throw UserError(fmt::format("--light {}={}: none of the files is the light of {}", group,
                                  lamp.name, group));
}

SceneLinearImage Relit::image() const {
  SceneLinearImage image{first_->display, first_->data, {}, metadata_};
  image.camera = first_->camera;
  for (const auto& entry : first_->metadata)
    if (entry.first.starts_with("abbe/") && entry.first != "abbe/lightGroup")
      image.metadata.push_back(entry);
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    const LinearRgb c = to_linear_srgb(colors_[i]);
    for (const double v : {c.r, c.g, c.b, static_cast<double>(alpha_[i])})
      image.rgba.push_back(static_cast<float>(v));
  }
  return image;
}

} // namespace

void add_options(CLI::App& app, RelightCommand& command) {
  app.add_option("cubes", command.cubes, "The files of render --relightable, NAME.light.GROUP.exr")
      ->required()
      ->type_name("CUBE");
  app.add_option("--light", command.lights,
                 "The lamp that a group of lights is to have, and its strength (default 1); may be "
                 "repeated")
      ->required()
      ->allow_extra_args(false)
      ->type_name("NAME=LAMP[,STRENGTH]");
  app.add_option("--lights", command.light_library, "A light library with more lamps")
      ->type_name("FILE");
  app.add_option("-o,--output", command.output, "Picture to write (.exr)")
      ->required()
      ->type_name("FILE");
  app.add_flag("-q,--quiet", command.quiet, "Print warnings and errors only");
}

int run(const RelightCommand& command) {
  if (!is_scene_linear_extension(command.output))
    throw UserError(fmt::format("{}: a relit picture goes into an EXR. The name should end in .exr",
                                command.output.string()));
  check_outputs({{command.output}, {}, {}}, command.cubes);
  Relit relit(given_lamps(command));
  for (const fs::path& cube : command.cubes)
    relit.add(cube);
  relit.check_used();
  for (const std::string& note : relit.notes())
    if (!command.quiet) say(note);
  const SceneLinearImage image = relit.image();
  return write_each({{command.output, [&] { return write_image(command.output, image, {}, {}); }}},
                    command.quiet)
             ? 0
             : kExitFailure;
}

} // namespace abbe
