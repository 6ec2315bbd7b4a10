#include "core/integrators/sky_view.h"

namespace abbe {

void SkyView::add(const Bundle& bundle, Lights::LeftOut left_out, BandSpan<float> throughput,
                  RadianceSums& sums) const {
  const dvec3& direction = bundle.state.ray.direction;
  const SkyPlan& sky = plan_.sky;
  if ((sky.lets_through || sky.tints) && passes(bundle.route, direction)) {
    const bool nothing_shows = sky.transparent || !lights_.sun_shows(direction);
    sums.let_through(throughput, sky.lets_through && nothing_shows);
    if (sky.transparent) return;
  }
  const dvec3 scattered_at = bundle.state.ray.at(-bundle.unseen_length);
  lights_.add_sky({scattered_at, direction, bundle.pdf}, left_out, throughput, sums);
}

} // namespace abbe
