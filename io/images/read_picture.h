#pragma once

#include "io/images/picture.h"

#include <filesystem>
#include <functional>

namespace abbe {

/// Reads a picture that the user names: an EXR, also of other programs, a PNG or a TIFF. It is read
/// in a child process. Codes of PNG and TIFF are decoded as sRGB, floating-point TIFF is taken as
/// linear. Throws UserError for a file that cannot be read, with the reason.
[[nodiscard]] Picture read_picture(const std::filesystem::path& file,
                                   const PictureRequest& request);

/// True for a name under which a picture is read, whatever its case.
[[nodiscard]] bool is_picture_name(const std::filesystem::path& file);

/// What it says of itself.
[[nodiscard]] PictureHeader read_picture_header(const std::filesystem::path& file);

/// Calls `use` for what is asked for, in blocks of rows from the top, so that no more than one
/// block is in memory. Throws like `read_picture`.
void read_picture_blocks(const std::filesystem::path& file, const PictureRequest& request,
                         const std::function<void(const Picture& block)>& use);

} // namespace abbe
