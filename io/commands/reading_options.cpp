#include "io/commands/reading_options.h"

#include "core/scene/user_error.h"
#include "io/libraries/read_display.h"
#include "spectral/illuminant.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace abbe {

void add_observer(CLI::App& app, std::optional<Observer>& observer) {
  app.add_option_function<std::string>(
         "--observer",
         [&observer](const std::string& text) {
           observer = text == "2deg" ? Observer::cie1931_2deg : Observer::cie1964_10deg;
         },
         "Who sees the bands: the CIE's standard observer of 1931 or of 1964")
      ->check(CLI::IsMember({"2deg", "10deg"}).description(""))
      ->type_name("2deg|10deg");
}

void add_reading_options(CLI::App& app, ReadingOptions& options) {
  CLI::Option* const csv = app.add_flag_callback(
      "--csv", [&options] { options.form = ReadingForm::csv; }, "As comma-separated values");
  app.add_flag_callback(
         "--json", [&options] { options.form = ReadingForm::json; }, "For programs, as JSON")
      ->excludes(csv);
  add_observer(app, options.observer);
  app.add_option_function<std::string>(
         "--white",
         [&options](const std::string& text) {
           const auto white = parse_white_point(text);
           if (!white || !*white)
             throw CLI::ValidationError(
                 "--white", fmt::format("\"{}\" is not a white: an illuminant such as D50, or x,y "
                                        "such as 0.3457,0.3585",
                                        text));
           options.white = *white;
         },
         "The white of L*a*b* and of dominant wavelengths, with Y = 1 (default D65)")
      ->type_name("NAME|x,y");
}

void add_picture(CLI::App& app, const std::string& name, std::filesystem::path& file,
                 const std::string& help) {
  app.add_option(name, file, help)->required()->type_name("FILE");
}

Chromaticity white_of(const ReadingOptions& options, Observer observer) {
  if (options.white) return options.white->seen_by(observer);
  // sRGB's own digits, so that its greys are grey.
  if (observer == Observer::cie1931_2deg) return kSrgbWhite;
  return WhitePoint::of_light(find_illuminant("D65").value()).seen_by(observer);
}

void require_bands(const std::vector<double>& wavelengths_nm, const std::filesystem::path& file,
                   const std::string& option) {
  if (wavelengths_nm.empty())
    throw UserError(fmt::format("{}: it has no bands for {}; abbe render writes them with "
                                "--spectral",
                                file.string(), option));
}

} // namespace abbe
