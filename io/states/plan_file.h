#pragma once

#include "core/scene/pixel_window.h"
#include "io/states/state_info.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace abbe {

/// Where the samples of a picture go, in the file that `render --plan-out` writes, so that parts
/// that are rendered apart spread theirs alike.
struct PlanFile {
  StateInfo info; ///< of the pilot samples that it was made from
  PixelWindow window;
  std::vector<float> shares;  ///< `find_shares`
  std::uint32_t checksum = 0; ///< of the shares, by which plans are told apart
};

/// Errors: those of replace_file.
void write_plan_file(const std::filesystem::path& file, const PlanFile& plan);
/// Errors: ReadError, which says why the file is refused.
[[nodiscard]] PlanFile read_plan_file(const std::filesystem::path& file);

} // namespace abbe
