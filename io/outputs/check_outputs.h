#pragma once

#include "io/images/write_image.h"

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace abbe {

/// Where the images of a render go, and its state.
struct Outputs {
  std::vector<std::filesystem::path> images;          ///< at least one, unless a part is rendered
  std::optional<std::filesystem::path> spectral = {}; ///< the EXR of all bands
  std::optional<std::filesystem::path> state = {};    ///< from which the rendering can go on
};

/// Where the image goes that an interrupted render leaves. There must be images.
[[nodiscard]] std::filesystem::path partial_path(const Outputs& outputs);

/// Finds before the long work what would make writing fail or harm after it. Throws UserError for
/// a name under which no image can be written, a place that cannot be written to, two files of
/// one name, and an image that would replace one of the files that the scene was read from.
/// `further` are the files that are written beside those that were named.
void check_outputs(const Outputs& outputs, std::span<const std::filesystem::path> inputs,
                   std::span<const std::filesystem::path> further = {});

/// Throws UserError where the configuration of OpenColorIO that is asked for cannot be used.
void check_ocio(const OutputOptions& options);

} // namespace abbe
