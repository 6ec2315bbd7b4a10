#include "io/commands/lens_command.h"

#include "core/cameras/lens_spot.h"
#include "core/scene/user_error.h"
#include "io/console/terminal.h"
#include "io/libraries/read_lens_prescription.h"
#include "io/text/json.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>

namespace abbe {
namespace {

/// A spectral line by its letter. (source: TIE29)
struct Line {
  const char* name;
  double nm;
};
constexpr std::array<Line, 6> kLines{{{"g", 435.8343},
                                      {"F", kLineF_nm},
                                      {"e", 546.0740},
                                      {"d", kLineD_nm},
                                      {"C", kLineC_nm},
                                      {"r", 706.5188}}};

/// What the lens does at one line.
struct LineRow {
  Line line;
  ParaxialLens paraxial;
  std::optional<LensSpot> spot; ///< empty where no light comes through
};

std::vector<LineRow> rows_of(const LensSystem& lens, double field_deg) {
  const double film = lens.paraxial(kLineD_nm).back_focal_length();
  std::vector<LineRow> rows;
  for (const Line& line : kLines)
    rows.push_back({line, lens.paraxial(line.nm), lens_spot(lens, line.nm, field_deg, film)});
  return rows;
}

void tell_json(const LensCommand& command, const LensSystem& lens,
               const std::vector<LineRow>& rows) {
  const ParaxialLens d = lens.paraxial(kLineD_nm);
  const double pupil = lens.entrance_pupil_diameter();
  std::string lines;
  for (const LineRow& row : rows)
    lines += fmt::format(
        "{}\n  {{\"line\": {}, \"nm\": {}, \"focal_length\": {}, \"back_focal_length\": {}, "
        "\"spot_radius\": {}}}",
        lines.empty() ? "" : ",", json_string(row.line.name), json_number(row.line.nm),
        json_number(row.paraxial.focal_length()), json_number(row.paraxial.back_focal_length()),
        row.spot ? json_number(row.spot->rms_radius) : "null");
  say(fmt::format("{{\"file\": {}, \"focal_length\": {}, \"back_focal_length\": {}, "
                  "\"front_focal_length\": {}, \"rear_principal_plane\": {}, "
                  "\"front_principal_plane\": {}, \"entrance_pupil_diameter\": {}, \"f_number\": "
                  "{}, \"field_deg\": {}, \"lines\": [{}\n]}}",
                  json_string(command.file.string()), json_number(d.focal_length()),
                  json_number(d.back_focal_length()), json_number(d.front_focal_length()),
                  json_number(d.rear_principal_plane()), json_number(d.front_principal_plane()),
                  json_number(pupil), json_number(d.focal_length() / pupil),
                  json_number(command.field_deg), lines));
}

void tell_table(const LensCommand& command, const LensSystem& lens,
                const std::vector<LineRow>& rows) {
  const ParaxialLens d = lens.paraxial(kLineD_nm);
  const double pupil = lens.entrance_pupil_diameter();
  const auto tell = [](const char* what, double mm, const char* from) {
    say(fmt::format("{:<26}{:>12.6f} mm{}", what, mm, from));
  };
  say(fmt::format("{}: {} surfaces, lengths in mm, at the d line", command.file.string(),
                  lens.surfaces().size()));
  tell("focal length", d.focal_length(), "");
  tell("back focal length", d.back_focal_length(), " behind the last vertex");
  tell("front focal length", d.front_focal_length(), " behind the first vertex");
  tell("rear principal plane", d.rear_principal_plane(), " behind the last vertex");
  tell("front principal plane", d.front_principal_plane(), " behind the first vertex");
  tell("entrance pupil, diameter", pupil, "");
  say(fmt::format("{:<26}{:>12.4f}", "f-number", d.focal_length() / pupil));
  say("");
  say(fmt::format("{:<4} {:>9}  {:>12} {:>12} {:>12}  {:>14} {:>7}", "line", "nm", "focal length",
                  "back focus", "less d's", "spot radius", "rays"));
  for (const LineRow& row : rows)
    say(fmt::format("{:<4} {:>9.4f}  {:>12.6f} {:>12.6f} {:>12.6f}  {:>14} {:>7}", row.line.name,
                    row.line.nm, row.paraxial.focal_length(), row.paraxial.back_focal_length(),
                    row.paraxial.back_focal_length() - d.back_focal_length(),
                    row.spot ? fmt::format("{:.6f}", row.spot->rms_radius) : "-",
                    row.spot ? row.spot->rays : 0));
  say(fmt::format("spot radius: root mean square about the middle, of parallel light at {:g} "
                  "degrees, where the d line has its paraxial focus",
                  command.field_deg));
}

} // namespace

void add_options(CLI::App& app, LensCommand& command) {
  app.add_option("file", command.file, "Lens file (.lens, .zmx or .dat)")
      ->required()
      ->type_name("FILE");
  app.add_option("--field", command.field_deg,
                 "Angle of the light of the spots to the axis, in degrees (default 0)")
      ->check(CLI::Range(0.0, 89.0).description(""))
      ->type_name("DEG");
  app.add_flag("--json", command.json, "For programs, as JSON");
}

int run(const LensCommand& command) {
  std::error_code error;
  if (!std::filesystem::exists(command.file, error))
    throw UserError(fmt::format("there is no file {}", command.file.string()));
  const LensSystem lens(read_lens_prescription(command.file, say_warning));
  const std::vector<LineRow> rows = rows_of(lens, command.field_deg);
  if (command.json)
    tell_json(command, lens, rows);
  else
    tell_table(command, lens, rows);
  return 0;
}

} // namespace abbe
