#pragma once

#include <stdexcept>

namespace abbe {

/// A mistake of the user's: in a file, on the command line, or in settings that exclude each other.
/// what() tells what is wrong and what would be right. All other exceptions are failures of the
/// machine or of the program itself.
class UserError : public std::runtime_error {
public:
  using runtime_error::runtime_error;
};

} // namespace abbe
