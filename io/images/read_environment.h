#pragma once

#include "core/scene/environment.h"
#include "io/text/token.h"

namespace abbe {

/// Reads the image of an EXR file, which is found from the folder of the file that names it: its
/// channels R, G and B, or Y for grey, in linear sRGB unless its tags say otherwise. Warns of
/// tags that are not known and of negative components. Throws ReadError at the name.
[[nodiscard]] Environment read_environment(const Token& name, const Warn& warn);

} // namespace abbe
