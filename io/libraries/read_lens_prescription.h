#pragma once

#include "core/scene/lens_prescription.h"
#include "io/text/token.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace abbe {

/// Reads a camera lens. Throws ReadError, also for data that describe no lens; warns of glasses
/// that are extrapolated. docs/scene_format.md describes the format.
[[nodiscard]] LensPrescription read_lens_prescription(const std::filesystem::path& file,
                                                      const Warn& warn);

/// The same for text; `file` is for messages, and names the lens.
[[nodiscard]] LensPrescription read_lens_prescription_text(std::string_view text,
                                                           const std::filesystem::path& file,
                                                           const Warn& warn);

/// The keywords of a lens file with their arguments.
[[nodiscard]] std::vector<std::string_view> lens_file_keywords();

} // namespace abbe
