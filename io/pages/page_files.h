#pragma once

#include <string_view>

namespace abbe {

/// The text of a file of this folder's pages (HTML, CSS, JavaScript), by its name without a folder.
/// The build puts these files into the program. Throws std::logic_error for a name that none has.
[[nodiscard]] std::string_view page_file(std::string_view name);

} // namespace abbe
