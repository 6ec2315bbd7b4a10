#pragma once

#include <string>
#include <string_view>

namespace abbe {

/// The bytes in base64 with padding, as RFC 4648 has it in its section 4.
[[nodiscard]] std::string base64(std::string_view bytes);

} // namespace abbe
