#pragma once

#include "core/scene/lens_prescription.h"
#include "io/text/read_error.h"

#include <filesystem>
#include <string_view>

namespace abbe {

// Lenses in the files of other programs. Throw ReadError for what cannot be read, not for data that
// describe no lens. The surfaces' names and order are those of our own files: from the object to
// the film.

/// A sequential lens of Zemax (.zmx): standard surfaces and even aspheres. Glasses are those of the
/// catalogue by name, or models with n_d and V_d.
[[nodiscard]] LensPrescription read_zmx_text(std::string_view text,
                                             const std::filesystem::path& file);

/// pbrt's table (.dat): radius, thickness, index and diameter in mm of each surface, with the stop
/// as a surface of radius 0. The indices are those of all wavelengths.
[[nodiscard]] LensPrescription read_dat_text(std::string_view text,
                                             const std::filesystem::path& file);

} // namespace abbe
