#include "core/planning/plan_samples.h"

#include "core/scene/user_error.h"

namespace abbe {

void plan_samples(RenderSettings& settings) {
  if (settings.samples_per_pixel == 0)
    settings.samples_per_pixel = settings.may_end_early() ? kMostSamplesPerPixel : kSamplesPerPixel;
  if (settings.adaptive == AdaptiveSampling::on && settings.noise > 0.0)
    throw UserError(
        "adaptive on and a noise target exclude each other: with a target each tile ends on its "
        "own. Leave out one of them");
  if (settings.adaptive != AdaptiveSampling::automatic) return;
  const bool pays = settings.noise == 0.0 && settings.samples_per_pixel >= kLeastAdaptiveSamples;
  settings.adaptive = pays ? AdaptiveSampling::on : AdaptiveSampling::off;
}

} // namespace abbe
