#pragma once

#include "io/commands/reading_options.h"
#include "io/images/write_image.h"
#include "io/settings/setting_text.h"

namespace abbe {

/// Makes pictures for screens, and scene-linear ones, of a picture that is there already.
struct DevelopCommand {
  static constexpr const char* kName = "develop";
  static constexpr const char* kHelp = "Give a rendered picture another look without a render";

  std::filesystem::path file;
  std::vector<std::filesystem::path> outputs; ///< at least one
  std::optional<Observer> observer;           ///< empty: as the file's colours are
  DisplayOverride display;
  OutputOptions output;
  std::vector<std::string> given; ///< the names of all options that were given
  bool quiet = false;
};
void add_options(CLI::App& app, DevelopCommand& command);
[[nodiscard]] int run(const DevelopCommand& command);

} // namespace abbe
