#include "io/commands/list_command.h"

#include "core/optics/conductor_reflectance.h"
#include "io/commands/list_plot.h"
#include "io/console/terminal.h"
#include "io/libraries/read_lights.h"
#include "io/libraries/read_materials.h"
#include "io/libraries/standard_lights.h"
#include "spectral/glass.h"
#include "spectral/metal.h"
#include "spectral/observer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>

namespace abbe {
namespace {

std::string number_or_dash(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

void list_glasses() {
  say(fmt::format("{:<24} {:>9} {:>7} {:>13}  {}", "glass", "n_d", "V_d", "nm", "source"));
  for (const Glass& glass : glass_catalogue())
    say(fmt::format("{:<24} {:>9.6f} {:>7} {:>6.0f}-{:<6.0f}  {}", glass.name,
                    refractive_index(glass.dispersion, kLineD_nm),
                    number_or_dash(abbe_number(glass.dispersion), 2), glass.lower_nm,
                    glass.upper_nm, glass.source));
}

void print_light(const std::string& name, const Curve& spectrum, const std::string& source) {
  const Xyz white = to_xyz(spectrum);
  const Chromaticity c = chromaticity(white);
  say(fmt::format("{:<16} {:>8.4f} {:>8.5f} {:>8.5f}  {}", name, white.y, c.x, c.y, source));
}

void list_lights(const ListCommand& command) {
  say(fmt::format("{:<16} {:>8} {:>8} {:>8}  {}", "light", "Y", "x", "y", "from"));
  if (const auto path = listed_library(command, "lights.filter"))
    for (const LightSpectrum& light : read_lights(*path, say_warning))
      print_light(light.name, spectrum(light), path->string());
  for (const std::string& name : standard_light_names())
    print_light(name, *standard_light({TokenKind::word, name, {}}), "built in");
}

void list_materials(const ListCommand& command) {
  const auto path = listed_library(command, "all.mtl");
  if (!path) {
    say("no material library here; name one: abbe list materials FILE");
    return;
  }
  say(fmt::format("{:<24} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}  {}", "material", "ambient",
                  "diffuse", "specul.", "reflect", "transp.", "n", "from"));
  for (const LibraryMaterial& m : read_materials(*path, say_warning))
    say(fmt::format("{:<24} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f}  {}", m.name,
                    m.ambient, m.diffuse, m.specular, m.reflectivity, m.transparency,
                    refractive_index(filling(m).index, kLineD_nm), path->string()));
}

void list_metals() {
  say(fmt::format("{:<8} {:>9} {:>9} {:>9} {:>9}", "metal", "n_d", "k_d", "R_450", "R_650"));
  const auto reflectance = [](const Metal& metal, double nm) {
    return conductor_reflectance(1.0, 1.0, metal.n.at(nm), metal.k.at(nm));
  };
  for (const Metal& metal : metal_catalogue())
    say(fmt::format("{:<8} {:>9.5f} {:>9.5f} {:>9.4f} {:>9.4f}", metal.name, metal.n.at(kLineD_nm),
                    metal.k.at(kLineD_nm), reflectance(metal, 450.0), reflectance(metal, 650.0)));
}

} // namespace

void add_options(CLI::App& app, ListCommand& command) {
  app.add_option("what", command.what, "glasses, lights, materials or metals")
      ->check(CLI::IsMember({"glasses", "lights", "materials", "metals"}));
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
      throw CLI::RequiredError("what (glasses, lights, materials or metals)");
    if (command.plot_file && command.plot_file->extension() != ".png")
      throw CLI::ValidationError("--plot-file", "the name should end in .png");
  });
}

int run(const ListCommand& command) {
  if (command.plot_name)
    list_plot(command);
  else if (command.what == "metals")
    list_metals();
  else if (command.what == "glasses")
    list_glasses();
  else if (command.what == "lights")
    list_lights(command);
  else
    list_materials(command);
  return 0;
}

} // namespace abbe
