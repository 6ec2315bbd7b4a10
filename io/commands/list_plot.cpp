#include "io/commands/list_plot.h"

#include "core/optics/conductor_reflectance.h"
#include "core/scene/user_error.h"
#include "io/console/terminal.h"
#include "io/images/write_png.h"
#include "io/libraries/read_library.h"
#include "io/libraries/read_lights.h"
#include "io/libraries/read_materials.h"
#include "io/libraries/read_spectrum.h"
#include "io/libraries/standard_lights.h"
#include "io/text/similar_names.h"
#include "spectral/band_grid.h"
#include "spectral/glass.h"
#include "spectral/metal.h"

#include <fmt/format.h>

#include <cstdio>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// Looks a name up among things of one kind, and notes the names that there are.
class Finder {
public:
  explicit Finder(const ListCommand& command) : command_(command), name_(*command.plot_name) {}

  std::optional<Plot> light() {
    if (const auto file = listed_library(command_, "lights.filter"))
      for (const LightSpectrum& entry : read_lights(*file, {})) {
        known_.push_back(entry.name);
        if (!same_name(entry.name, name_)) continue;
        if (is_standard_light(name_))
          say_error(fmt::format("warning: {} is the light of {}, which hides the built-in light of "
                                "this name",
                                name_, file->string()));
        return curve(entry.name + ": light per nm, 1 = equal energy", spectrum(entry));
      }
    if (is_spectrum_file(name_))
      return curve(name_ + ": light per nm, with Y = 1",
                   read_lamp({TokenKind::word, name_, {"--plot", 1, 1}}, say_warning));
    for (std::string& name : standard_light_names())
      known_.push_back(std::move(name));
    if (const auto lamp = standard_light({TokenKind::word, name_, {"--plot", 1, 1}}))
      return curve(name_ + ": light per nm, 1 = equal energy", *lamp);
    return std::nullopt;
  }

  std::optional<Plot> material() {
    const auto file = listed_library(command_, "all.mtl");
    if (!file) return std::nullopt;
    for (const LibraryMaterial& entry : read_materials(*file, {})) {
      known_.push_back(entry.name);
      if (same_name(entry.name, name_)) return curve(entry.name + ": reflectance", entry.colour);
    }
    return std::nullopt;
  }

  std::optional<Plot> metal() {
    for (const Metal& one : metal_catalogue())
      known_.push_back(one.name);
    const Metal* metal = find_metal(name_);
    if (!metal) return std::nullopt;
    return Plot{metal->name + ": reflectance at normal incidence in air",
                [metal](int count) {
                  const auto n = means_of(metal->n, count), k = means_of(metal->k, count);
                  std::vector<double> r(n.size());
                  for (std::size_t i = 0; i < r.size(); ++i)
                    r[i] = conductor_reflectance(1.0, 1.0, n[i], k[i]);
                  return r;
                },
                true};
  }

  std::optional<Plot> glass() {
    for (const Glass& one : glass_catalogue())
      known_.push_back(one.name);
    const Glass* glass = find_glass(name_);
    if (!glass) return std::nullopt;
    return Plot{glass->name + ": refractive index",
                [glass](int count) {
                  std::vector<double> n;
                  for (int i = 0; i < count; ++i)
                    n.push_back(refractive_index(glass->dispersion, BandGrid(count).center_nm(i)));
                  return n;
                },
                false};
  }

  [[noreturn]] void fail() const {
    throw UserError(fmt::format("there is nothing called \"{}\" to plot. {}", name_,
                                did_you_mean(name_, known_, "abbe list shows names")));
  }

private:
  static Plot curve(std::string title, const Curve& values) {
    return {std::move(title), [values](int count) { return means_of(values, count); }, true};
  }

  const ListCommand& command_;
  std::string name_;
  std::vector<std::string> known_;
};

} // namespace

std::optional<fs::path> listed_library(const ListCommand& command, const char* name) {
  if (command.library) return command.library;
  for (const char* folder : {".", "scenes"})
    if (auto path = fs::path(folder) / name; exists(path)) return path;
  return std::nullopt;
}

Plot find_plot(const ListCommand& command) {
  Finder finder(command);
  const auto asked = [&](std::string_view kind) {
    return command.what.empty() || command.what == kind;
  };
  std::optional<Plot> plot;
  if (asked("lights")) plot = finder.light();
  if (!plot && asked("materials")) plot = finder.material();
  if (!plot && asked("metals")) plot = finder.metal();
  if (!plot && asked("glasses")) plot = finder.glass();
  if (!plot) finder.fail();
  return *plot;
}

void list_plot(const ListCommand& command) {
  const Plot plot = find_plot(command);
  if (!command.plot_file) {
    std::string text = plot_text(plot);
    if (text.ends_with('\n')) text.pop_back();
    say(text);
    return;
  }
  write_png(*command.plot_file, plot_image(plot));
  say(fmt::format("wrote {}", command.plot_file->string()));
}

} // namespace abbe
