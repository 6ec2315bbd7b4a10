#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace abbe {

/// Where the images of a render go.
struct Outputs {
  std::vector<std::filesystem::path> images;     ///< at least one
  std::optional<std::filesystem::path> spectral; ///< the EXR of all bands
};

/// Where the image goes that an interrupted render leaves.
[[nodiscard]] std::filesystem::path partial_path(const Outputs& outputs);

/// Finds before the long work what would make writing fail or harm after it. Throws UserError for
/// a name under which no image can be written, a place that cannot be written to, two images of
/// one name, and an image that would replace one of the files that the scene was read from.
void check_outputs(const Outputs& outputs, std::span<const std::filesystem::path> inputs);

} // namespace abbe
