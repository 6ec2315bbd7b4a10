#pragma once

#include "core/image/image.h"
#include "io/images/write_image.h"
#include "io/outputs/check_outputs.h"

#include <string_view>

namespace abbe {

/// The layer that a channel belongs to: what stands before its last dot, without the number that
/// Cryptomatte adds. A channel without a dot is a layer of its own.
[[nodiscard]] std::string_view layer_of(std::string_view channel);

/// Moves each layer of the image into an EXR of its own, beside each EXR of the outputs: NAME.exr
/// has its depth in NAME.depth.exr. Returns false when some file could not be written.
[[nodiscard]] bool write_layer_files(SceneLinearImage& image, const Outputs& outputs,
                                     const OutputOptions& options, bool quiet);

} // namespace abbe
