#pragma once

#include "io/text/read_error.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace abbe {

/// What libFuzzer tries, as the text that a reader takes.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Reads an input. It may be read or be refused by a ReadError that names the file; every other
/// exception is a finding, and so is an error whose place is missing.
template <class Read>
int try_input(std::string_view file, const Read& read) {
  try {
    read();
  } catch (const ReadError& refused) {
    if (std::string_view(refused.what()).find(file) == std::string_view::npos) {
      std::fprintf(stderr, "an error without its place: %s\n", refused.what());
      std::abort();
    }
  }
  return 0;
}

/// A warning must be a text; nobody reads it here.
inline void ignore_warning(const std::string&) {}

} // namespace abbe
