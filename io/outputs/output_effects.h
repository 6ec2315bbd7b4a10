#pragma once

#include "core/scene/display_settings.h"
#include "io/images/write_image.h"
#include "io/outputs/check_outputs.h"
#include "io/text/read_error.h"

namespace abbe {

/// Warns of options of the images that have no effect on any image that is written, such as
/// --png-depth without a PNG. `given` are the names of the options that were given.
void warn_of_outputs(std::span<const std::string> given, const Outputs& outputs,
                     const OutputOptions& options, const Warn& warn);

/// Warns of --adaptation where no white point is told, by the command line or the scene.
void warn_of_adaptation(std::span<const std::string> given, const Outputs& outputs,
                        const DisplaySettings& display, const Warn& warn);

} // namespace abbe
