#pragma once

#include "tests/fuzz/fuzz_input.h"

#include <sys/mman.h>
#include <unistd.h>

namespace abbe {

/// A file that is only in memory, until the end of its scope.
struct MemoryFile {
  MemoryFile(std::string_view bytes, const char* name) : file(::memfd_create(name, MFD_CLOEXEC)) {
    if (file < 0 || ::write(file, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      std::abort();
    path = "/proc/self/fd/" + std::to_string(file);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(file); }

  int file;
  std::string path;
};

} // namespace abbe
