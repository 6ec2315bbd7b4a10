#include "io/scene_language/input_files.h"

#include "io/files/regular_file.h"

#include <fmt/format.h>

#include <stdexcept>

namespace abbe {

namespace fs = std::filesystem;

fs::path input_file(InputFiles& files, const Token& name, const fs::path& folder,
                    const InputKind& kind) {
  fs::path file = folder / name.text;
  std::error_code error;
  if (!fs::exists(file, error) && !error)
    throw ReadError(name.where, fmt::format("there is no {} \"{}\"", kind.noun, file.string()),
                    std::string(kind.found_from), "Check the name, or write the whole path");
  try {
    require_regular_file(file);
  } catch (const std::runtime_error& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" cannot be read", file.string()), fault.what(),
                    fmt::format("Name a {} that can be read", kind.noun));
  }
  files.push_back(file);
  return file;
}

void add_input(InputFiles& files, const Token& name) {
  files.push_back(fs::path(name.where.file).parent_path() / name.text);
}

} // namespace abbe
