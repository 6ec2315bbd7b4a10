#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace abbe {

/// The bytes in base64 with padding, as RFC 4648 has it in its section 4.
[[nodiscard]] std::string base64(std::string_view bytes);

/// The bytes that such a text stands for, which may leave its padding out; none where a character
/// stands that base64 has not.
[[nodiscard]] std::optional<std::string> base64_decoded(std::string_view text);

} // namespace abbe
