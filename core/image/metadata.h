#pragma once

#include "core/image/image.h"
#include "core/plan/plan.h"

namespace abbe {

/// The settings that made the picture, as name and value, by the table of settings. Nothing of the
/// machine, the time or the number of threads.
[[nodiscard]] Metadata render_metadata(const Plan& plan);
/// The settings that made the display's picture of it.
[[nodiscard]] Metadata display_metadata(const DisplaySettings& settings, Observer observer);

} // namespace abbe
