#include "io/program/list.h"

#include "core/optics/conductor_reflectance.h"
#include "io/libraries/read_lights.h"
#include "io/libraries/read_materials.h"
#include "io/libraries/standard_lights.h"
#include "io/program/list_plot.h"
#include "io/program/terminal.h"
#include "spectral/glass.h"
#include "spectral/metal.h"
#include "spectral/observer.h"

#include <fmt/format.h>

#include <cmath>

namespace abbe {
namespace {

void print_warning(const std::string& message) {
  say_error("warning: " + message);
}

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

void list_lights(const Options& options) {
  say(fmt::format("{:<16} {:>8} {:>8} {:>8}  {}", "light", "Y", "x", "y", "from"));
  if (const auto path = listed_library(options, "lights.filter"))
    for (const LightSpectrum& light : read_lights(*path, print_warning))
      print_light(light.name, spectrum(light), path->string());
  for (const std::string& name : standard_light_names())
    print_light(name, *standard_light({TokenKind::word, name, {}}), "built in");
}

void list_materials(const Options& options) {
  const auto path = listed_library(options, "all.mtl");
  if (!path) {
    say("no material library here; name one: abbe list materials FILE");
    return;
  }
  say(fmt::format("{:<24} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}  {}", "material", "ambient",
                  "diffuse", "specul.", "reflect", "transp.", "n", "from"));
  for (const LibraryMaterial& m : read_materials(*path, print_warning))
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

void list(const Options& options) {
  if (options.plot_name)
    list_plot(options);
  else if (options.list_what == "metals")
    list_metals();
  else if (options.list_what == "glasses")
    list_glasses();
  else if (options.list_what == "lights")
    list_lights(options);
  else
    list_materials(options);
}

} // namespace abbe
