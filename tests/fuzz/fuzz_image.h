#pragma once

#include "tests/fuzz/memory_file.h"

#include <exception>

namespace abbe {

/// Reads an image in this process, so that what happens inside is seen. All exceptions are
/// refusals: the scene's reader gives them their place.
template <class Read>
int try_image(std::string_view bytes, const char* name, const Read& read) {
  const MemoryFile file(bytes, name);
  try {
    read(file.path);
  } catch (const std::exception&) { // refused
  }
  return 0;
}

} // namespace abbe
