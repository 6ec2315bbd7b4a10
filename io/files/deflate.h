#pragma once

#include <string>
#include <string_view>

namespace abbe {

/// The bytes, compressed as zlib's format has it, which browsers call "deflate".
[[nodiscard]] std::string deflated(std::string_view bytes);

} // namespace abbe
