#include "io/commands/list_command.h"

#include "core/optics/conductor_reflectance.h"
#include "core/scene/user_error.h"
#include "io/commands/list_plot.h"
#include "io/console/terminal.h"
#include "io/libraries/read_lights.h"
#include "io/libraries/read_materials.h"
#include "io/libraries/standard_lights.h"
#include "io/text/similar_names.h"
#include "spectral/data_table.h"
#include "spectral/glass.h"
#include "spectral/metal.h"
#include "spectral/observer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace abbe {
namespace {

std::string number_or_dash(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

/// Tells the rows whose names hold a word, whatever its case, under a header where there are any.
class Listing {
public:
  explicit Listing(std::string word) : word_(lower_case(std::move(word))) {}

  void begin(std::string header) { header_ = std::move(header); }
  void add(const std::string& name, const std::string& row) {
    names_.push_back(name);
    if (lower_case(name).find(word_) == std::string::npos) return;
    if (!header_.empty()) say(std::exchange(header_, ""));
    say(row);
    ++count_;
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

private:
  /// Of ASCII letters alone.
  static std::string lower_case(std::string text) {
    for (char& c : text)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
  }

  std::string word_, header_;
  std::vector<std::string> names_; ///< all that there are
  int count_ = 0;
};

void list_glasses(Listing& listing) {
  listing.begin(
      fmt::format("{:<24} {:>9} {:>7} {:>13}  {}", "glass", "n_d", "V_d", "nm", "source"));
  for (const Glass& glass : glass_catalogue())
    listing.add(glass.name, fmt::format("{:<24} {:>9.6f} {:>7} {:>6.0f}-{:<6.0f}  {}", glass.name,
                                        refractive_index(glass.dispersion, kLineD_nm),
                                        number_or_dash(abbe_number(glass.dispersion), 2),
                                        glass.lower_nm, glass.upper_nm, glass.source));
}

void add_light(Listing& listing, const std::string& name, const Curve& spectrum,
               const std::string& source) {
  const Xyz white = to_xyz(spectrum);
  const Chromaticity c = chromaticity(white);
  listing.add(
      name, fmt::format("{:<16} {:>8.4f} {:>8.5f} {:>8.5f}  {}", name, white.y, c.x, c.y, source));
}

void list_lights(const ListCommand& command, Listing& listing, const Warn& warn) {
  listing.begin(fmt::format("{:<16} {:>8} {:>8} {:>8}  {}", "light", "Y", "x", "y", "from"));
  if (const auto path = listed_library(command, "lights.filter"))
    for (const LightSpectrum& light : read_lights(*path, warn))
      add_light(listing, light.name, spectrum(light), path->string());
  for (const std::string& name : standard_light_names())
    add_light(listing, name, *standard_light({TokenKind::word, name, {}}), "built in");
}

/// False where there is no library of materials.
bool list_materials(const ListCommand& command, Listing& listing, const Warn& warn) {
  const auto path = listed_library(command, "all.mtl");
  if (!path) return false;
  listing.begin(fmt::format("{:<24} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}  {}", "material", "ambient",
                            "diffuse", "specul.", "reflect", "transp.", "n", "from"));
  for (const LibraryMaterial& m : read_materials(*path, warn))
    listing.add(m.name, fmt::format("{:<24} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f}  "
                                    "{}",
                                    m.name, m.ambient, m.diffuse, m.specular, m.reflectivity,
                                    m.transparency, refractive_index(filling(m).index, kLineD_nm),
                                    path->string()));
  return true;
}

void list_metals(Listing& listing) {
  listing.begin(
      fmt::format("{:<8} {:>9} {:>9} {:>9} {:>9}", "metal", "n_d", "k_d", "R_450", "R_650"));
  const auto reflectance = [](const Metal& metal, double nm) {
    return conductor_reflectance(1.0, 1.0, metal.n.at(nm), metal.k.at(nm));
  };
  for (const Metal& metal : metal_catalogue())
    listing.add(metal.name, fmt::format("{:<8} {:>9.5f} {:>9.5f} {:>9.4f} {:>9.4f}", metal.name,
                                        metal.n.at(kLineD_nm), metal.k.at(kLineD_nm),
                                        reflectance(metal, 450.0), reflectance(metal, 650.0)));
}

/// Everything whose name holds the word.
void search(const ListCommand& command) {
  Listing listing(command.what);
  list_glasses(listing);
  // A library that is named has either lights or materials; which, its reader knows.
  if (!command.library || same_name(command.library->extension().string(), ".filter"))
    list_lights(command, listing, {});
  if (!command.library || same_name(command.library->extension().string(), ".mtl"))
    (void)list_materials(command, listing, {});
  list_metals(listing);
  if (listing.count() == 0)
    throw UserError(fmt::format(
        "\"{}\" is neither glasses, lights, materials or metals, nor in any of their names. {}",
        command.what,
        did_you_mean(command.what, listing.names(), "abbe list glasses shows all glasses")));
}

bool is_kind(std::string_view what) {
  return what == "glasses" || what == "lights" || what == "materials" || what == "metals";
}

} // namespace

void add_options(CLI::App& app, ListCommand& command) {
  app.add_option("what", command.what,
                 "glasses, lights, materials or metals, or a part of a name to search for in all")
      ->type_name("WHAT");
  app.add_option("library", command.library,
                 "Light or material library to list too (default: those beside the scenes)");
  app.add_option("--plot", command.plot_name,
                 "Draw a light's spectrum, a material's or metal's reflectance, a glass's n")
      ->type_name("NAME");
  app.add_option("--plot-file", command.plot_file, "Draw it into a PNG instead of the terminal")
      ->needs("--plot")
      ->type_name("FILE");
  app.parse_complete_callback([&command] {
    if (command.what.empty() && !command.plot_name)
      throw CLI::RequiredError("what (glasses, lights, materials or metals, or a part of a name)");
    if (command.plot_name && !command.what.empty() && !is_kind(command.what))
      throw CLI::ValidationError("what", "with --plot it is glasses, lights, materials or metals");
    if (command.plot_file && command.plot_file->extension() != ".png")
      throw CLI::ValidationError("--plot-file", "the name should end in .png");
  });
}

int run(const ListCommand& command) {
  if (command.plot_name) {
    list_plot(command);
    return 0;
  }
  Listing all("");
  if (!is_kind(command.what))
    search(command);
  else if (command.what == "metals")
    list_metals(all);
  else if (command.what == "glasses")
    list_glasses(all);
  else if (command.what == "lights")
    list_lights(command, all, say_warning);
  else if (!list_materials(command, all, say_warning))
    say("no material library here; name one: abbe list materials FILE");
  return 0;
}

} // namespace abbe
