#include "core/planning/plan_relightable.h"

#include "core/planning/make_plan.h"
#include "core/scene/user_error.h"

#include <cassert>
#include <utility>

namespace abbe {
namespace {

void even_out(Curve& spectrum) {
  if (!spectrum.zero()) spectrum = Curve::constant(1.0);
}

} // namespace

Scene equal_energy_scene(Scene scene) {
  even_out(scene.background);
  even_out(scene.global_ambient);
  for (Light& light : scene.lights)
    even_out(light.spectrum);
  for (Material& material : scene.materials)
    even_out(material.emission);
  if (scene.environment) even_out(scene.environment->light);
  return scene;
}

Plan plan_relightable(const Scene& scene, const Scene& equal_energy, RenderSettings settings) {
  if (settings.adaptive == AdaptiveSampling::on || settings.may_end_early())
    throw UserError("a relightable rendering takes the same samples whatever its lamps are. Leave "
                    "out --relightable, or adaptive on, --noise and --time");
  settings.adaptive = AdaptiveSampling::off;
  settings.relightable = true;
  Plan plan = make_plan(equal_energy, settings);
  Plan own = make_plan(scene, settings);
  assert(plan.sources.size() == own.sources.size());
  plan.sources = std::move(own.sources);
  plan.accumulators = std::move(own.accumulators);
  return plan;
}

} // namespace abbe
