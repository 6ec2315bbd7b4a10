#pragma once

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace abbe {

/// Throws std::runtime_error with the system's words for the call that has just failed.
[[noreturn]] inline void throw_errno() {
  throw std::runtime_error(std::generic_category().message(errno));
}

} // namespace abbe
