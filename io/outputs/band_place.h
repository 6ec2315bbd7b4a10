#pragma once

#include "core/film/layer.h"

#include <filesystem>

namespace abbe {

/// Where the sums of all bands go when they are large: TMPDIR, else the folder of the picture that
/// is made of them, else this folder.
[[nodiscard]] BandPlace band_place(const std::filesystem::path& picture);

} // namespace abbe
