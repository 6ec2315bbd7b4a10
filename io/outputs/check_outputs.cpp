#include "io/outputs/check_outputs.h"

#include "core/scene/user_error.h"
#include "io/files/atomic_file.h"
#include "io/images/write_image.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// Throws when a file of this name surely could not be written.
void check_place(const fs::path& path) {
  try {
    require_replaceable(path);
  } catch (const std::runtime_error& error) {
    throw UserError(error.what());
  }
}

void check_extensions(const Outputs& outputs) {
  for (const fs::path& path : outputs.images)
    if (!is_known_image_extension(path))
      throw UserError(fmt::format("{}: no picture can be written under this name. "
                                  "The name should end in {}",
                                  path.string(), known_image_extensions()));
  if (outputs.spectral && outputs.spectral->extension() != ".exr")
    throw UserError(fmt::format("{}: all bands go into an EXR. The name should end in .exr",
                                outputs.spectral->string()));
}

/// Two names of one file count as one file: links, and paths by another way.
void check_against(const fs::path& output, std::span<const fs::path> inputs,
                   std::string_view which) {
  for (const fs::path& input : inputs) {
    std::error_code error; // what does not exist yet is no input
    if (fs::equivalent(output, input, error))
      throw UserError(fmt::format("{}: {} would replace {}, which the scene is read from. "
                                  "Give the output another name",
                                  output.string(), which, input.string()));
  }
}

} // namespace

fs::path partial_path(const Outputs& outputs) {
  return fs::path(outputs.images.front()).replace_extension(".partial.exr");
}

void check_ocio(const OutputOptions& options) {
  if (!options.ocio) return;
  if (options.ocio->config.empty())
    throw UserError("--ocio-display and --ocio-view need a configuration. Give --ocio FILE");
  (void)OcioTransform(*options.ocio);
}

void check_outputs(const Outputs& outputs, std::span<const fs::path> inputs,
                   std::span<const fs::path> further) {
  check_extensions(outputs);
  for (const fs::path& path : further)
    check_against(path, inputs, "this file");
  std::vector<fs::path> all = outputs.images;
  if (outputs.spectral) all.push_back(*outputs.spectral);
  if (outputs.state) all.push_back(*outputs.state);
  all.insert(all.end(), further.begin(), further.end());
  std::set<fs::path> places;
  for (const fs::path& path : all) {
    check_place(path);
    if (!places.insert(fs::weakly_canonical(fs::absolute(path))).second)
      throw UserError(fmt::format("{}: two outputs would have this name", path.string()));
    check_against(path, inputs, path == outputs.state ? "this state" : "this picture");
  }
  if (!outputs.images.empty())
    check_against(partial_path(outputs), inputs, "what an interrupted render leaves");
}

} // namespace abbe
