#pragma once

#include "core/scene/texture.h"
#include "io/images/picture.h"
#include "io/text/token.h"

#include <filesystem>

namespace abbe {

/// The file that a token names, found from the folder of the file that names it.
[[nodiscard]] std::filesystem::path image_path(const Token& name);

/// Reads reflectances from a PNG (8 or 16 bits, taken as sRGB whatever it says; alpha is left out)
/// or an EXR (R, G and B, or Y for grey; linear sRGB unless its tags say otherwise). Components
/// beyond 0 and 1 are clamped, with a warning. Throws ReadError at the name.
[[nodiscard]] ReflectanceImage read_image(const Token& name, const Warn& warn);

/// Throws std::runtime_error; components are as in the file, decoded.
[[nodiscard]] ReflectanceImage read_png(const std::filesystem::path& file);

/// The same with all that the file says of itself, through its colour profile where it has one.
[[nodiscard]] Picture read_png_picture(const std::filesystem::path& file,
                                       const PictureRequest& request);

/// Throws std::runtime_error for an image that would take more memory than an image may, so that
/// nothing is allocated for what a damaged or hostile file declares.
void require_image_memory(std::uint64_t width, std::uint64_t height, std::uint64_t pixel_bytes);

} // namespace abbe
