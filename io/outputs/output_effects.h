#pragma once

#include "io/images/write_image.h"
#include "io/outputs/check_outputs.h"
#include "io/text/read_error.h"

namespace abbe {

/// Warns of options of the images that have no effect on any image that is written, such as
/// --png-depth without a PNG. `given` are the names of the options that were given.
void warn_of_outputs(std::span<const std::string> given, const Outputs& outputs,
                     const OutputOptions& options, const Warn& warn);

} // namespace abbe
