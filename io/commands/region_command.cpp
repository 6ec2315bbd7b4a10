#include "io/commands/region_command.h"

#include "io/console/terminal.h"
#include "io/readings/color_facts.h"
#include "io/readings/picture_reading.h"
#include "io/text/json.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>

namespace abbe {
namespace {

void tell_table(const RegionCommand& command, const RegionReading& region,
                const std::vector<Fact>& facts) {
  say(fmt::format("region {}, {} to {}, {} of {}: {} pixels; means, and standard deviations of "
                  "the pixels",
                  command.x0, command.y0, command.x1, command.y1, command.file.string(),
                  region.pixels));
  for (const Fact& fact : facts)
    if (!fact.name.empty()) say(fmt::format("{:<24}{}", fact.name, fact.text));
  const Xyz& d = region.deviation;
  say(fmt::format("{:<24}{:.6f}  {:.6f}  {:.6f}", "deviation of X Y Z", d.x, d.y, d.z));
  if (region.band_means.empty()) return;
  say(fmt::format("{:>10}  {:>14}  {}", "nm", "mean per nm", "deviation"));
  for (std::size_t band = 0; band < region.band_means.size(); ++band)
    say(fmt::format("{:>10.3f}  {:>14.6g}  {:.6g}", region.wavelengths_nm[band],
                    region.band_means[band], region.band_deviations[band]));
}

void tell_csv(const RegionReading& region) {
  say("nm,mean,deviation");
  for (std::size_t band = 0; band < region.band_means.size(); ++band)
    say(fmt::format("{:.6f},{:.9g},{:.9g}", region.wavelengths_nm[band], region.band_means[band],
                    region.band_deviations[band]));
}

void tell_json(const RegionCommand& command, const RegionReading& region,
               const std::vector<Fact>& facts) {
  const Xyz& d = region.deviation;
  say(fmt::format("{{\"file\": {}, \"region\": [{}, {}, {}, {}], \"pixels\": {}, {}, "
                  "\"XYZ_deviation\": {}, \"nm\": {}, \"values\": {}, \"deviations\": {}}}",
                  json_string(command.file.string()), command.x0, command.y0, command.x1,
                  command.y1, region.pixels, json_members(facts),
                  json_list(std::array{d.x, d.y, d.z}), json_list(region.wavelengths_nm),
                  json_list(region.band_means), json_list(region.band_deviations)));
}

} // namespace

void add_options(CLI::App& app, RegionCommand& command) {
  add_picture(app, "file", command.file, "Picture: EXR, PNG or TIFF");
  app.add_option("x0", command.x0, "First column, from 0 at the left edge of the whole frame")
      ->required();
  app.add_option("y0", command.y0, "First row, from 0 at the top")->required();
  app.add_option("x1", command.x1, "The column after the last, as in --crop")->required();
  app.add_option("y1", command.y1, "The row after the last")->required();
  add_reading_options(app, command.options);
}

int run(const RegionCommand& command) {
  const RegionReading region =
      read_region(command.file, {command.x0, command.y0, command.x1, command.y1},
                  {command.options.observer, true});
  if (command.options.form == ReadingForm::csv)
    require_bands(region.wavelengths_nm, command.file, "--csv");
  const Chromaticity white = white_of(command.options, region.observer);
  const std::vector<Fact> facts = listed(color_facts(region.mean, white, region.observer));
  switch (command.options.form) {
  case ReadingForm::table:
    tell_table(command, region, facts);
    break;
  case ReadingForm::csv:
    tell_csv(region);
    break;
  case ReadingForm::json:
    tell_json(command, region, facts);
    break;
  }
  return 0;
}

} // namespace abbe
