#pragma once

#include <string>
#include <string_view>

namespace abbe {

/// What bytes packed by gzip hold, of which there may be several members in a row. Throws
/// std::runtime_error with the reason alone where they are damaged, end too early, or hold more
/// than there is memory for.
[[nodiscard]] std::string gunzip(std::string_view packed);

} // namespace abbe
