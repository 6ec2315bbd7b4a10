#pragma once

#include "io/program/command_line.h"

namespace abbe {

/// Prints the glasses, lights, materials or metals that scenes can name, or plots one of them.
void list(const Options& options);

} // namespace abbe
