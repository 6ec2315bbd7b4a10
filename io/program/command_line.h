#pragma once

#include "io/commands/command.h"

namespace abbe {

/// Reads the command line. Help, version and usage errors are printed here.
[[nodiscard]] Command parse_command_line(int argc, const char* const* argv);

} // namespace abbe
