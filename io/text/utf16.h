#pragma once

#include <string>
#include <string_view>

namespace abbe {

/// The text of a file of Zemax's, which may be in UTF-16 with its mark: its ASCII, and "?" for
/// every other character. Text of bytes stays as it is.
[[nodiscard]] std::string without_utf16(std::string_view text);

} // namespace abbe
