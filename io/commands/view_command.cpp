#include "io/commands/view_command.h"

#include "core/scene/user_error.h"
#include "io/console/terminal.h"
#include "io/files/atomic_file.h"
#include "io/images/read_picture.h"
#include "io/pages/picture_page.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// The pictures that lie in a folder, by name.
std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_picture_name(entry.path())) pictures.push_back(entry.path());
  if (pictures.empty())
    throw UserError(fmt::format("{}: there is no picture in this folder, neither .exr nor .png nor "
                                ".tiff",
                                folder.string()));
  std::ranges::sort(pictures);
  return pictures;
}

} // namespace

void add_options(CLI::App& app, ViewCommand& command) {
  app.add_option("files", command.files, "Pictures (EXR, PNG or TIFF), or folders of pictures")
      ->required()
      ->type_name("FILE|DIR");
  app.add_option("-o,--output", command.page, "The page to write (default: the first name, .html)")
      ->type_name("FILE");
}

int run(const ViewCommand& command) {
  std::vector<fs::path> pictures;
  for (const fs::path& file : command.files) {
    if (!fs::is_directory(file)) {
      pictures.push_back(file);
      continue;
    }
    const std::vector<fs::path> found = pictures_in(file);
    pictures.insert(pictures.end(), found.begin(), found.end());
  }
  fs::path page = command.page;
  if (page.empty()) page = fs::path(command.files.front()).replace_extension(".html");
  if (page.extension() != ".html" && page.extension() != ".htm")
    throw UserError(fmt::format("{}: the name of a page should end in .html", page.string()));
  require_replaceable(page);
  const PageSummary written = write_picture_page(page, pictures);
  say(fmt::format("wrote {}: {} {}, {:.1f} MB", page.string(), written.pictures,
                  written.pictures == 1 ? "picture" : "pictures",
                  static_cast<double>(written.bytes) * 1e-6));
  if (written.band_error > 0.0)
    say(fmt::format("spectra in it are off by at most {:.2g} % of the range of their pixel's "
                    "values",
                    100.0 * written.band_error));
  return 0;
}

} // namespace abbe
