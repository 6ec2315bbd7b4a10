#include "io/commands/glass_command.h"

#include "core/scene/user_error.h"
#include "io/console/terminal.h"
#include "io/libraries/read_glass_files.h"
#include "io/text/similar_names.h"
#include "spectral/data_table.h"
#include "spectral/glass.h"
#include "spectral/square.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>

namespace abbe {
namespace {

constexpr double kFirst_nm = 380.0, kLast_nm = 780.0;

/// A glass that is shown, and what it absorbs where that is known.
struct ShownGlass : Glass {
  std::optional<Curve> absorption_per_mm;
};

ShownGlass glass_of(const std::string& name, const std::vector<FileGlass>& catalogue) {
  std::vector<std::string> known;
  for (const FileGlass& file : catalogue) {
    if (same_name(file.glass.name, name))
      return {file.glass,
              file.absorption_per_mm.zero() ? std::nullopt : std::optional(file.absorption_per_mm)};
    known.push_back(file.glass.name);
  }
  if (const Glass* glass = find_glass(name)) return {*glass, std::nullopt};
  for (const Glass& glass : glass_catalogue())
    known.push_back(glass.name);
  throw UserError(fmt::format("there is no glass \"{}\". {}", name,
                              did_you_mean(name, known, "abbe list glasses shows all")));
}

double index_at(const Glass& glass, double nm) {
  return refractive_index(glass.dispersion, nm);
}

/// The slope of n, per um, from a tenth of a nanometre to both sides: its error is that of a third
/// derivative, 1e-7 of it in common glass.
double slope_per_um(const Glass& glass, double nm) {
  constexpr double kAsideNm = 0.1;
  return (index_at(glass, nm + kAsideNm) - index_at(glass, nm - kAsideNm)) /
         (2.0 * kAsideNm * 1e-3);
}

/// What a plate in air lets pass of light that meets it straight on, with all reflections between
/// its two surfaces and nothing absorbed: 2n / (n^2 + 1). (source: BW99)
double plate_transmittance(double n) {
  return 2.0 * n / (square(n) + 1.0);
}

/// What the glass lets pass between its surfaces (Lambert's law). What it absorbs must be known.
double internal_transmittance(const GlassCommand& command, const ShownGlass& glass, double nm) {
  return std::exp(-glass.absorption_per_mm->at(nm) * command.thickness_mm);
}

std::string text_or_dash(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

/// A row of the summary, with a column for each glass.
template <class Tell>
void tell_row(const std::vector<ShownGlass>& glasses, std::string_view what, const Tell& tell) {
  std::string row = fmt::format("{:<22}", what);
  for (const ShownGlass& glass : glasses)
    row += fmt::format("{:<30}", tell(glass));
  row.erase(row.find_last_not_of(' ') + 1);
  say(row);
}

void tell_summary(const std::vector<ShownGlass>& glasses) {
  tell_row(glasses, "", [](const ShownGlass& g) { return g.name; });
  const auto at = [](double nm) {
    return [nm](const ShownGlass& g) { return fmt::format("{:.6f}", index_at(g, nm)); };
  };
  tell_row(glasses, "n_d  587.5618 nm", at(kLineD_nm));
  tell_row(glasses, "n_F  486.1327 nm", at(kLineF_nm));
  tell_row(glasses, "n_C  656.2725 nm", at(kLineC_nm));
  tell_row(glasses, "n_F - n_C", [](const ShownGlass& g) {
    return fmt::format("{:.6f}", index_at(g, kLineF_nm) - index_at(g, kLineC_nm));
  });
  tell_row(glasses, "V_d", [](const ShownGlass& g) {
    const double v = abbe_number(g.dispersion);
    return std::isfinite(v) ? fmt::format("{:.2f}", v) : std::string("-");
  });
  tell_row(glasses, "published n_d, V_d", [](const ShownGlass& g) {
    return fmt::format("{}, {}", text_or_dash(g.n_d, 6), text_or_dash(g.v_d, 2));
  });
  tell_row(glasses, "range in nm",
           [](const ShownGlass& g) { return fmt::format("{:g} to {:g}", g.lower_nm, g.upper_nm); });
  tell_row(glasses, "absorption",
           [](const ShownGlass& g) { return g.absorption_per_mm ? "in the table" : "not known"; });
  for (const ShownGlass& glass : glasses) {
    say(fmt::format("{}: coefficients: {}", glass.name, glass.source));
    if (!glass.published_source.empty())
      say(fmt::format("{}: published values: {}", glass.name, glass.published_source));
  }
}

void tell_table(const GlassCommand& command, const std::vector<ShownGlass>& glasses) {
  std::string header = fmt::format("{:>9}", "nm");
  for (const ShownGlass& glass : glasses)
    header += fmt::format("  {:>12} {:>12} {:>9}{}", "n, " + glass.name, "dn/d um", "plate",
                          glass.absorption_per_mm ? fmt::format(" {:>9}", "internal") : "");
  say(header);
  for (double nm = kFirst_nm; nm <= kLast_nm + 1e-9; nm += command.step_nm) {
    std::string row = fmt::format("{:>9.3f}", nm);
    for (const ShownGlass& glass : glasses) {
      const double n = index_at(glass, nm);
      row += fmt::format("  {:>12.7f} {:>12.7f} {:>9.6f}{}", n, slope_per_um(glass, nm),
                         plate_transmittance(n),
                         glass.absorption_per_mm
                             ? fmt::format(" {:>9.6f}", internal_transmittance(command, glass, nm))
                             : "");
      if (nm < glass.lower_nm || nm > glass.upper_nm) row += " *";
    }
    say(row);
  }
  say("plate: what a plate in air lets pass straight on, where the glass absorbs nothing");
  for (const ShownGlass& glass : glasses)
    say(glass.absorption_per_mm
            ? fmt::format("internal: what {:g} mm of {} let pass between its surfaces",
                          command.thickness_mm, glass.name)
            : fmt::format("{}: how much it absorbs is not known here", glass.name));
  for (const ShownGlass& glass : glasses)
    if (glass.lower_nm > kFirst_nm || glass.upper_nm < kLast_nm)
      say(fmt::format("*: beyond the range of the coefficients of {}", glass.name));
}

void tell_csv(const GlassCommand& command, const std::vector<ShownGlass>& glasses) {
  std::string header = "nm";
  for (const ShownGlass& glass : glasses)
    header += fmt::format(",n {0},dn/dum {0},plate {0}{1}", glass.name,
                          glass.absorption_per_mm ? ",internal " + glass.name : "");
  say(header);
  for (double nm = kFirst_nm; nm <= kLast_nm + 1e-9; nm += command.step_nm) {
    std::string row = fmt::format("{:.6f}", nm);
    for (const ShownGlass& glass : glasses) {
      const double n = index_at(glass, nm);
      row +=
          fmt::format(",{:.9f},{:.9f},{:.9f}", n, slope_per_um(glass, nm), plate_transmittance(n));
      if (glass.absorption_per_mm)
        row += fmt::format(",{:.9f}", internal_transmittance(command, glass, nm));
    }
    say(row);
  }
}

} // namespace

void add_options(CLI::App& app, GlassCommand& command) {
  app.add_option("names", command.names, "One glass of the catalogue, or two")
      ->required()
      ->expected(1, 2)
      ->type_name("NAME");
  app.add_option("--glasses", command.catalogue,
                 "A maker's catalogue (.agf) with more glasses, and what they absorb")
      ->type_name("FILE");
  app.add_option("--thickness", command.thickness_mm,
                 "Thickness for the internal transmittance in mm (default 10)")
      ->check(CLI::Range(1e-3, 1e6).description(""))
      ->type_name("MM");
  app.add_option("--step", command.step_nm, "Step of the table in nm, from 0.1 (default 20)")
      ->check(CLI::Range(0.1, 400.0).description(""))
      ->type_name("NM");
  app.add_flag("--csv", command.csv, "The table alone, as comma-separated values");
}

int run(const GlassCommand& command) {
  std::vector<FileGlass> catalogue;
  if (command.catalogue)
    catalogue = read_agf_text(read_text_file(*command.catalogue), *command.catalogue, say_warning);
  std::vector<ShownGlass> glasses;
  for (const std::string& name : command.names)
    glasses.push_back(glass_of(name, catalogue));
  if (command.csv) {
    tell_csv(command, glasses);
    return 0;
  }
  tell_summary(glasses);
  say("");
  tell_table(command, glasses);
  return 0;
}

} // namespace abbe
