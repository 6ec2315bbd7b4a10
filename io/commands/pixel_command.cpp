#include "io/commands/pixel_command.h"

#include "io/console/terminal.h"
#include "io/images/write_png.h"
#include "io/plots/plot.h"
#include "io/readings/color_facts.h"
#include "io/readings/picture_reading.h"
#include "io/text/json.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace abbe {
namespace {

/// The spectrum of a pixel as a curve to draw.
Plot plot_of(const std::vector<double>& nm, const std::vector<double>& values,
             const std::string& title) {
  const Curve curve = Curve::table(nm, values, Outside::zero);
  return {title, [curve](int count) { return means_of(curve, count); }, true};
}

struct Told {
  const PictureReading& reading;
  std::vector<Fact> facts;
  std::optional<double> delta_e; ///< to the other pixel
};

void tell_table(const PixelCommand& command, const Told& told) {
  const PixelReading& pixel = told.reading.pixels.front();
  say(fmt::format("pixel {}, {} of {}", pixel.place.x, pixel.place.y, command.file.string()));
  for (const Fact& fact : told.facts)
    if (!fact.name.empty()) say(fmt::format("{:<24}{}", fact.name, fact.text));
  if (told.delta_e)
    say(fmt::format("{:<24}{:.4f} to the pixel {}, {}", "CIEDE2000", *told.delta_e, command.to[0],
                    command.to[1]));
  if (pixel.bands.empty()) return;
  say(fmt::format("{:>10}  value per nm", "nm"));
  for (std::size_t band = 0; band < pixel.bands.size(); ++band)
    say(fmt::format("{:>10.3f}  {:.6g}", told.reading.wavelengths_nm[band], pixel.bands[band]));
}

void tell_csv(const PictureReading& reading) {
  say(reading.pixels.size() > 1 ? "nm,value,other" : "nm,value");
  for (std::size_t band = 0; band < reading.wavelengths_nm.size(); ++band) {
    std::string line = fmt::format("{:.6f}", reading.wavelengths_nm[band]);
    for (const PixelReading& pixel : reading.pixels)
      line += fmt::format(",{:.9g}", pixel.bands[band]);
    say(line);
  }
}

void tell_json(const PixelCommand& command, const Told& told, const Chromaticity& white) {
  const PixelReading& pixel = told.reading.pixels.front();
  std::string json =
      fmt::format("{{\"file\": {}, \"x\": {}, \"y\": {}, {}, \"white\": [{}, {}]",
                  json_string(command.file.string()), pixel.place.x, pixel.place.y,
                  json_members(told.facts), json_number(white.x), json_number(white.y));
  if (told.delta_e)
    json += fmt::format(", \"to\": [{}, {}], \"delta_e_2000\": {}", command.to[0], command.to[1],
                        json_number(*told.delta_e));
  say(json + fmt::format(", \"nm\": {}, \"values\": {}}}", json_list(told.reading.wavelengths_nm),
                         json_list(pixel.bands)));
}

} // namespace

void add_options(CLI::App& app, PixelCommand& command) {
  add_picture(app, "file", command.file, "Picture: EXR, PNG or TIFF");
  app.add_option("x", command.x, "Column, from 0 at the left edge of the whole frame")->required();
  app.add_option("y", command.y, "Row, from 0 at the top")->required();
  app.add_option("--to", command.to, "Tell the difference to this pixel, by CIEDE2000")
      ->expected(2)
      ->type_name("X Y");
  app.add_option_function<std::string>(
         "--plot", [&command](const std::string& name) { command.plot_file = name; },
         "Draw the spectrum into a PNG")
      ->check([](const std::string& name) {
        return name.ends_with(".png") ? std::string() : "the name should end in .png";
      })
      ->type_name("FILE");
  add_reading_options(app, command.options);
}

int run(const PixelCommand& command) {
  std::vector<PixelPlace> places{{command.x, command.y}};
  if (!command.to.empty()) places.push_back({command.to[0], command.to[1]});
  const PictureReading reading =
      read_pixels(command.file, places, {command.options.observer, true});
  if (command.options.form == ReadingForm::csv)
    require_bands(reading.wavelengths_nm, command.file, "--csv");
  if (command.plot_file) require_bands(reading.wavelengths_nm, command.file, "--plot");
  const Chromaticity white = white_of(command.options, reading.observer);
  const ColorFacts facts = color_facts(reading.pixels.front().color, white, reading.observer);
  Told told{reading, listed(facts), {}};
  if (reading.pixels.size() > 1)
    told.delta_e = delta_e_2000(
        facts.lab, color_facts(reading.pixels.back().color, white, reading.observer).lab);
  switch (command.options.form) {
  case ReadingForm::table:
    tell_table(command, told);
    break;
  case ReadingForm::csv:
    tell_csv(reading);
    break;
  case ReadingForm::json:
    tell_json(command, told, white);
    break;
  }
  if (!command.plot_file) return 0;
  write_png(*command.plot_file,
            plot_image(plot_of(reading.wavelengths_nm, reading.pixels.front().bands,
                               fmt::format("pixel {}, {}", command.x, command.y))));
  say_error(fmt::format("wrote {}", command.plot_file->string()));
  return 0;
}

} // namespace abbe
