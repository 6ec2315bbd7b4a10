#pragma once

#include <filesystem>
#include <string>

namespace abbe {

/// Returns when the path leads to a file of ordinary content that can be opened for reading.
/// Opening never waits: a pipe, a device, a socket and a folder are errors. Throws
/// std::runtime_error with the reason alone, such as "it is a folder" or "No such file or
/// directory".
void require_regular_file(const std::filesystem::path& path);

/// All bytes of such a file. Throws like `require_regular_file`.
[[nodiscard]] std::string read_regular_file(const std::filesystem::path& path);

} // namespace abbe
