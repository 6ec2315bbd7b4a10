#pragma once

#include "core/film/film.h"
#include "core/image/image.h"
#include "core/plan/plan.h"

namespace abbe {

/// The settings that made the picture, as name and value, by the table of settings. Nothing of the
/// machine, the time or the number of threads.
[[nodiscard]] Metadata render_metadata(const Plan& plan);
/// What the limit of depth has taken of the picture's light, where there is one.
[[nodiscard]] Metadata lost_metadata(const Film& film);
/// The same, the number of samples that a pixel really has in the mean, and the unit of the values.
[[nodiscard]] Metadata film_metadata(const Film& film);
/// The settings that made the display's picture of it.
[[nodiscard]] Metadata display_metadata(const DisplaySettings& settings, Observer observer);

} // namespace abbe
