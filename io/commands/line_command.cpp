#include "io/commands/line_command.h"

#include "io/console/terminal.h"
#include "io/readings/color_facts.h"
#include "io/readings/picture_reading.h"
#include "io/text/json.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace abbe {
namespace {

std::string nm_or_dash(const std::optional<DominantWavelength>& dominant) {
  if (!dominant) return "-";
  return fmt::format("{}{:.2f}", dominant->complementary ? "c " : "", dominant->nm);
}

void tell_table(const PixelReading& pixel, const ColorFacts& facts) {
  const Chromaticity c = facts.xy.value_or(Chromaticity{});
  say(fmt::format("{:>6} {:>6}  {:>12.6f} {:>12.6f} {:>12.6f}  {:>8} {:>8}  {:>9}", pixel.place.x,
                  pixel.place.y, pixel.color.x, pixel.color.y, pixel.color.z,
                  facts.xy ? fmt::format("{:.5f}", c.x) : "-",
                  facts.xy ? fmt::format("{:.5f}", c.y) : "-", nm_or_dash(facts.dominant)));
}

void tell_csv(const PixelReading& pixel) {
  std::string line = fmt::format("{},{},{:.9g},{:.9g},{:.9g}", pixel.place.x, pixel.place.y,
                                 pixel.color.x, pixel.color.y, pixel.color.z);
  for (const double value : pixel.bands)
    line += fmt::format(",{:.9g}", value);
  say(line);
}

std::string json_of(const PixelReading& pixel, const ColorFacts& facts) {
  return fmt::format("  {{\"x\": {}, \"y\": {}, {}, \"values\": {}}}", pixel.place.x, pixel.place.y,
                     json_members(listed(facts)), json_list(pixel.bands));
}

void tell_json(const std::filesystem::path& file, const PictureReading& reading,
               const Chromaticity& white) {
  std::string pixels;
  for (const PixelReading& pixel : reading.pixels)
    pixels += (pixels.empty() ? "\n" : ",\n") +
              json_of(pixel, color_facts(pixel.color, white, reading.observer));
  say(fmt::format("{{\"file\": {}, \"nm\": {}, \"pixels\": [{}\n]}}", json_string(file.string()),
                  json_list(reading.wavelengths_nm), pixels));
}

} // namespace

void add_options(CLI::App& app, LineCommand& command) {
  add_picture(app, "file", command.file, "Picture: EXR, PNG or TIFF");
  app.add_option("x0", command.x0, "Column of the first pixel")->required();
  app.add_option("y0", command.y0, "Its row, from 0 at the top of the whole frame")->required();
  app.add_option("x1", command.x1, "Column of the last pixel")->required();
  app.add_option("y1", command.y1, "Its row")->required();
  add_reading_options(app, command.options);
}

int run(const LineCommand& command) {
  const auto places = pixels_on_line({command.x0, command.y0}, {command.x1, command.y1});
  const PictureReading reading =
      read_pixels(command.file, places, {command.options.observer, true});
  const Chromaticity white = white_of(command.options, reading.observer);
  if (command.options.form == ReadingForm::json) {
    tell_json(command.file, reading, white);
    return 0;
  }
  if (command.options.form == ReadingForm::csv) {
    std::string header = "x,y,X,Y,Z";
    for (const double nm : reading.wavelengths_nm)
      header += fmt::format(",{:.6f}", nm);
    say(header);
  } else {
    say(fmt::format("{:>6} {:>6}  {:>12} {:>12} {:>12}  {:>8} {:>8}  {:>9}", "column", "row", "X",
                    "Y", "Z", "x", "y", "dom. nm"));
  }
  for (const PixelReading& pixel : reading.pixels) {
    if (command.options.form == ReadingForm::csv)
      tell_csv(pixel);
    else
      tell_table(pixel, color_facts(pixel.color, white, reading.observer));
  }
  return 0;
}

} // namespace abbe
