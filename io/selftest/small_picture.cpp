#include "io/selftest/small_picture.h"

#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "io/scene_language/read_scene.h"
#include "io/selftest/single_ray.h"
#include "spectral/band_grid.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace abbe {

std::string exact_text(double value) {
  return fmt::format("{:.17g}", value);
}

Scene scene_of_text(const std::string& text) {
  Scene scene = read_scene_text(text, "selftest.sdl", [](const std::string&) {});
  scene.settings.adaptive = AdaptiveSampling::off;
  return scene;
}

Rendering rendered(const Scene& scene) {
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  Rendering r = render(scene, plan, world, BandPlace{});
  const RefusedValues& refused = r.film.refused();
  if (refused.not_finite + refused.negative + refused.overflow > 0)
    throw std::runtime_error("the film had to refuse a value");
  return r;
}

Rendering rendered(const std::string& text) {
  return rendered(scene_of_text(text));
}

std::string narrow_view(double angle_deg) {
  const double angle = angle_deg * kRadiansPerDegree;
  return fmt::format(
      "eye {} 0 {} lookAt 0 0 0 fieldOfView 0.0001 imageSize 1 1 filter box samples 1 "
      "jitter off exact on minThroughput 1e-12 maxRecursionDepth 100000\n",
      exact_text(50.0 * std::sin(angle)), exact_text(50.0 * std::cos(angle)));
}

double radiance_seen(const std::string& text, double lambda_nm, double angle_deg) {
  const Rendering r = rendered(narrow_view(angle_deg) + text);
  return r.film.radiance(0, 0, BandGrid(kSampleCount).band_of(lambda_nm));
}

} // namespace abbe
