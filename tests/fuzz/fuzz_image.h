#pragma once

#include "tests/fuzz/fuzz_input.h"

#include <sys/mman.h>
#include <unistd.h>

#include <exception>
#include <string>

namespace abbe {

/// Reads an image from a file in memory, in this process, so that what happens inside is seen. All
/// exceptions are refusals: the scene's reader gives them their place.
template <class Read>
int try_image(const std::uint8_t* data, std::size_t size, const char* name, const Read& read) {
  const int file = ::memfd_create(name, MFD_CLOEXEC);
  if (file < 0 || ::write(file, data, size) != static_cast<ssize_t>(size)) std::abort();
  try {
    read("/proc/self/fd/" + std::to_string(file));
  } catch (const std::exception&) {
  }
  ::close(file);
  return 0;
}

} // namespace abbe
