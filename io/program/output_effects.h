#pragma once

#include "io/program/check_outputs.h"
#include "io/program/command_line.h"
#include "io/text/read_error.h"

namespace abbe {

/// Warns of options of the images that have no effect on any image that is written, such as
/// --png-depth without a PNG.
void warn_of_outputs(const Options& options, const Outputs& outputs, const Warn& warn);

} // namespace abbe
