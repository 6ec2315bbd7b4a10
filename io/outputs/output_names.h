#pragma once

#include "core/plan/plan.h"
#include "io/images/write_image.h"
#include "io/outputs/check_outputs.h"

#include <string>
#include <string_view>
#include <vector>

namespace abbe {

// The files that are written beside the pictures that the command line names.

/// NAME.exr has its depth in NAME.depth.exr.
[[nodiscard]] std::filesystem::path layer_file(const std::filesystem::path& image,
                                               std::string_view layer);
/// The bands of each group of lights: NAME.light.GROUP.exr.
[[nodiscard]] std::filesystem::path cube_file(const Outputs& outputs, const std::string& group);
/// What the band adds to the picture: NAME.band001.exr for the first.
[[nodiscard]] std::filesystem::path band_file(const std::filesystem::path& image, int band);

/// The names of the layers that a picture has beside its colours.
[[nodiscard]] std::vector<std::string> layer_names(const SceneLinearImage& image);

/// All such files of a rendering.
[[nodiscard]] std::vector<std::filesystem::path> further_files(const Scene& scene, const Plan& plan,
                                                               const Outputs& outputs,
                                                               const OutputOptions& options);

} // namespace abbe
