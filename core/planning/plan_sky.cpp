#include "core/planning/plan_sky.h"

#include "spectral/illuminant.h"
#include "spectral/observer.h"

#include <algorithm>

namespace abbe {
namespace {

bool gives_light(const Curve& spectrum, const BandGrid& grid) {
  return std::ranges::any_of(band_means(grid, spectrum), [](double mean) { return mean > 0.0; });
}

} // namespace

void plan_sky(const Scene& scene, Plan& plan) {
  SkyPlan& sky = plan.sky;
  sky.transparent = plan.settings.sky == Sky::transparent;
  sky.lets_through =
      sky.transparent || !(plan.environment || gives_light(scene.background, plan.grid));
  sky.tints = plan.settings.layers.has(ExtraLayer::transmittance);
  for (auto* axis : {&sky.x, &sky.y, &sky.z})
    axis->assign(plan.stride, 0.0f);
  const auto weights =
      band_weights(plan.grid, find_illuminant("D65").value(), plan.settings.observer);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    sky.x[b] = static_cast<float>(weights[b].x);
    sky.y[b] = static_cast<float>(weights[b].y);
    sky.z[b] = static_cast<float>(weights[b].z);
  }
}

} // namespace abbe
