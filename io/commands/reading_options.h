#pragma once

#include "core/scene/display_settings.h"
#include "io/readings/picture_colors.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

// What the commands that read pictures have in common.
namespace abbe {

/// How a reading is told.
enum class ReadingForm { table, csv, json };

struct ReadingOptions {
  ReadingForm form = ReadingForm::table;
  std::optional<Observer> observer; ///< empty: the 2 degree observer, where there are bands
  std::optional<WhitePoint> white;  ///< empty: D65
};
void add_reading_options(CLI::App& app, ReadingOptions& options);

/// `--observer`, for commands that have no other of these options.
void add_observer(CLI::App& app, std::optional<Observer>& observer);

/// The file of a picture to read, which must be given.
void add_picture(CLI::App& app, const std::string& name, std::filesystem::path& file,
                 const std::string& help);

/// The white of colours as this observer sees it. That of sRGB is the usual one.
[[nodiscard]] Chromaticity white_of(const ReadingOptions& options, Observer observer);

/// Throws UserError for a file of pictures without bands, where a table of them is asked for.
void require_bands(const std::vector<double>& wavelengths_nm, const std::filesystem::path& file,
                   const std::string& option);

} // namespace abbe
