#include "core/planning/make_plan.h"

#include "core/lights/emission.h"
#include "core/lights/light_kinds.h"
#include "core/lights/specular_targets.h"
#include "core/planning/plan_bands.h"
#include "core/planning/plan_camera.h"
#include "core/planning/plan_extent.h"
#include "core/planning/plan_groups.h"
#include "core/planning/plan_lines.h"
#include "core/planning/plan_materials.h"
#include "core/planning/plan_notes.h"
#include "core/planning/plan_samples.h"
#include "core/planning/plan_sky.h"
#include "core/planning/plan_sources.h"
#include "core/planning/plan_surfaces.h"
#include "core/planning/plan_tiles.h"
#include "core/scene/user_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

/// Which lights light paths begin at, if any.
void plan_caustics(const Scene& scene, Plan& plan) {
  const RenderSettings& settings = plan.settings;
  if (settings.integrator != Integrator::path || settings.caustics == Caustics::off) return;
  const std::size_t specular = specular_targets(scene, plan).size();
  if (specular == 0) {
    plan.notes.push_back("nothing mirrors or refracts: no light-side passes");
    return;
  }
  for (const Light& light : scene.lights) {
    if (!endless_flux(light)) continue;
    if (settings.caustics == Caustics::on)
      throw UserError(fmt::format(
          "the light {} has no flux that could be followed: it does not fall off with distance. "
          "Give it falloff square, or leave caustics on out",
          light.name.empty() ? "of a colour" : light.name));
    plan.notes.push_back(fmt::format("the light {} does not fall off with distance, so it has no "
                                     "flux: no caustics of it",
                                     light.name.empty() ? "of a colour" : light.name));
  }
  const std::size_t emitting = Emission(scene, plan).lights().size();
  plan.caustics = emitting > 0;
  // Light that comes through glass is counted where it is bent to.
  if (plan.caustics && plan.settings.shadows == ShadowRule::attenuated)
    plan.settings.shadows = ShadowRule::opaque;
  plan.notes.push_back(emitting > 0
                           ? fmt::format("light-side passes: {} of the lights shine on things that "
                                         "mirror or refract",
                                         emitting)
                           : "no light shines on anything that mirrors or refracts: no light-side "
                             "passes");
}

} // namespace

Plan make_plan(const Scene& scene, const RenderSettings& settings) {
  check_extent(scene);
  Plan plan;
  plan.settings = settings;
  if (settings.shadows == ShadowRule::automatic)
    plan.settings.shadows =
        settings.integrator == Integrator::path ? ShadowRule::opaque : ShadowRule::attenuated;
  plan_samples(plan.settings);
  plan.grid = BandGrid(settings.bands);
  plan.stride = padded_band_count(settings.bands);

  plan.lines = lines_of_bands(scene, plan.grid);
  SourcePlanner sources(plan);
  sources.add(scene.background);
  sources.add(scene.global_ambient);
  for (const Light& light : scene.lights)
    sources.add(light.spectrum);
  plan_materials(scene, plan, sources);
  if (scene.environment) {
    plan.environment =
        EnvironmentMap::make(*scene.environment, table_wavelengths(plan), settings.bright_sky);
    if (plan.environment) plan.environment_source = sources.add(scene.environment->light);
  }
  plan_groups(scene, plan);
  plan_media(scene, plan);
  plan_sky(scene, plan);
  plan_bands(plan);

  const PixelWindow full{0, 0, settings.width, settings.height};
  plan.window = settings.crop.value_or(full);
  if (plan.window.x0 < 0 || plan.window.y0 < 0 || plan.window.x1 > full.x1 ||
      plan.window.y1 > full.y1 || plan.window.width() <= 0 || plan.window.height() <= 0)
    throw UserError(fmt::format("the crop {},{},{},{} is not a part of the {} x {} image",
                                plan.window.x0, plan.window.y0, plan.window.x1, plan.window.y1,
                                full.x1, full.y1));
  plan.camera = camera_matrices(scene.camera, settings.width, settings.height);
  plan.tiles = make_tiles(scene, plan.window, settings);
  plan_albedos(plan);
  plan_caustics(scene, plan);
  plan.disperses = !plan.layers.empty() ||
                   std::any_of(plan.media.begin(), plan.media.end(), [](const MediumPlan& m) {
                     return m.drops || !m.index.achromatic();
                   });
  plan.quantum = film_quantum(scene, plan.grid, settings.observer);
  note_content(scene, plan);
  note_surfaces(plan);
  return plan;
}

} // namespace abbe
