#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace abbe {

/// A file to write. `write` returns what the user should know of it, which is mostly nothing.
struct OutputJob {
  std::filesystem::path path;
  std::function<std::string()> write;
};

/// Writes all the files, also where some fail. Tells each on standard output unless quiet, and each
/// failure on standard error. Returns false when there was one.
[[nodiscard]] bool write_each(const std::vector<OutputJob>& jobs, bool quiet);

} // namespace abbe
