#include "io/commands/diff_command.h"

#include "core/scene/user_error.h"
#include "io/console/exit_codes.h"
#include "io/console/terminal.h"
#include "io/images/write_png.h"
#include "io/readings/picture_difference.h"
#include "io/text/json.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace abbe {
namespace {

void tell_table(const DiffCommand& command, const PictureDifference& d) {
  say(fmt::format("{} against {}: {} pixels", command.picture.string(), command.reference.string(),
                  d.delta_e.size()));
  say(fmt::format("{:<24}{:.6g}", "RMSE, linear sRGB", d.rmse));
  say(fmt::format("{:<24}{:.6g}", "relMSE", d.rel_mse));
  say(fmt::format("{:<24}mean {:.4f}, 95 % below {:.4f}, largest {:.4f}", "CIEDE2000",
                  d.mean_delta_e, d.delta_e_95, d.worst_delta_e));
  if (d.not_finite > 0) say(fmt::format("{:<24}{}", "pixels without numbers", d.not_finite));
  if (d.bands.empty()) return;
  const auto worst = std::ranges::max_element(d.bands, {}, &BandDifference::relative);
  say(fmt::format("{:<24}{}, the most different at {:.3f} nm: {:.4g} of its root mean square",
                  "bands", d.bands.size(), worst->nm, worst->relative));
  if (!command.bands) return;
  say(fmt::format("{:>10}  {:>12}  relative", "nm", "RMSE"));
  for (const BandDifference& band : d.bands)
    say(fmt::format("{:>10.3f}  {:>12.6g}  {:.6g}", band.nm, band.rmse, band.relative));
}

void tell_csv(const PictureDifference& d) {
  say("nm,rmse,relative");
  for (const BandDifference& band : d.bands)
    say(fmt::format("{:.6f},{:.9g},{:.9g}", band.nm, band.rmse, band.relative));
}

void tell_json(const PictureDifference& d) {
  std::string bands;
  for (const BandDifference& band : d.bands)
    bands += fmt::format("{}\n  {{\"nm\": {}, \"rmse\": {}, \"relative\": {}}}",
                         bands.empty() ? "" : ",", json_number(band.nm), json_number(band.rmse),
                         json_number(band.relative));
  say(fmt::format("{{\"pixels\": {}, \"not_finite\": {}, \"rmse\": {}, \"rel_mse\": {}, "
                  "\"delta_e_mean\": {}, \"delta_e_95\": {}, \"delta_e_largest\": {}, "
                  "\"bands\": [{}]}}",
                  d.delta_e.size(), d.not_finite, json_number(d.rmse), json_number(d.rel_mse),
                  json_number(d.mean_delta_e), json_number(d.delta_e_95),
                  json_number(d.worst_delta_e), bands));
}

double measured(const PictureDifference& d, DifferenceMeasure measure) {
  switch (measure) {
  case DifferenceMeasure::rmse:
    return d.rmse;
  case DifferenceMeasure::rel_mse:
    return d.rel_mse;
  case DifferenceMeasure::mean_delta_e:
    return d.mean_delta_e;
  case DifferenceMeasure::delta_e_95:
    return d.delta_e_95;
  }
  return d.rmse;
}

} // namespace

void add_options(CLI::App& app, DiffCommand& command) {
  add_picture(app, "picture", command.picture, "Picture: EXR, PNG or TIFF");
  add_picture(app, "reference", command.reference, "The picture to compare it with");
  CLI::Option* const tolerance =
      app.add_option("--tolerance", command.tolerance,
                     "End with 1 where the difference is more than this, or a pixel has no numbers")
          ->check(CLI::NonNegativeNumber.description(""))
          ->type_name("N");
  const std::map<std::string, DifferenceMeasure> measures{
      {"rmse", DifferenceMeasure::rmse},
      {"relmse", DifferenceMeasure::rel_mse},
      {"de2000", DifferenceMeasure::mean_delta_e},
      {"de2000-95", DifferenceMeasure::delta_e_95}};
  app.add_option("--measure", command.measure,
                 "What the tolerance is of: rmse (default), relmse, de2000 or de2000-95")
      ->transform(CLI::CheckedTransformer(measures).description(""))
      ->needs(tolerance)
      ->type_name("NAME");
  CLI::Option* const output =
      app.add_option_function<std::string>(
             "-o,--output", [&command](const std::string& name) { command.output = name; },
             "PNG of CIEDE2000 in false colours")
          ->check([](const std::string& name) {
            return name.ends_with(".png") ? std::string() : "the name should end in .png";
          })
          ->type_name("FILE");
  app.add_option("--most", command.most, "The difference that is shown as yellow (default 10)")
      ->check(CLI::PositiveNumber.description(""))
      ->needs(output)
      ->type_name("N");
  app.add_flag("--bands", command.bands, "A table of all bands");
  add_reading_options(app, command.options);
}

int run(const DiffCommand& command) {
  for (const std::filesystem::path& input : {command.picture, command.reference}) {
    std::error_code error; // what does not exist yet is no input
    if (command.output && std::filesystem::equivalent(*command.output, input, error))
      throw UserError(fmt::format("{}: the picture would replace one of those that are compared. "
                                  "Give it another name",
                                  command.output->string()));
  }
  const ReadingOptions& options = command.options;
  const Chromaticity white = white_of(options, options.observer.value_or(Observer::cie1931_2deg));
  const PictureDifference difference =
      compare_pictures(command.picture, command.reference, {options.observer, false}, white);
  if (options.form == ReadingForm::csv || command.bands) {
    std::vector<double> nm;
    for (const BandDifference& band : difference.bands)
      nm.push_back(band.nm);
    require_bands(nm, command.picture, "a comparison of bands with this reference");
  }
  switch (options.form) {
  case ReadingForm::table:
    tell_table(command, difference);
    break;
  case ReadingForm::csv:
    tell_csv(difference);
    break;
  case ReadingForm::json:
    tell_json(difference);
    break;
  }
  if (command.output) {
    write_png(*command.output, false_color(difference, command.most));
    say_error(fmt::format("wrote {}", command.output->string()));
  }
  if (!command.tolerance) return 0;
  const bool within = measured(difference, command.measure) <= *command.tolerance;
  return within && difference.not_finite == 0 ? 0 : kExitFailure;
}

} // namespace abbe
