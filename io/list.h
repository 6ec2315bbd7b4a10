#pragma once

#include "io/command_line.h"

namespace abbe {

/// Prints the glasses, lights or materials that scenes can name.
void list(const Options& options);

} // namespace abbe
