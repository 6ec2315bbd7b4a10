#pragma once

#include <cstddef>
#include <filesystem>

namespace abbe {

/// While it lives, `remove_temporary_files` removes the file of this name. Names beyond the first
/// few at one time, and names of more than 4095 bytes, are not kept.
class TemporaryName {
public:
  explicit TemporaryName(const std::filesystem::path& path);
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  ~TemporaryName();

private:
  std::size_t slot_;
};

/// Removes all files whose names are kept. A signal handler that ends the program may call it.
void remove_temporary_files() noexcept;

} // namespace abbe
