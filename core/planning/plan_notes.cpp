#include "core/planning/plan_notes.h"

#include "core/emitters/sampled_surface.h"
#include "core/lights/scene_extent.h"
#include "core/planning/plan_drops.h"
#include "core/planning/plan_extent.h"
#include "spectral/fraunhofer.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

/// Paths find light that is not aimed at too, but with more noise.
void note_lamps_met_by_chance(const Scene& scene, Plan& plan) {
  if (plan.settings.integrator != Integrator::path) return;
  const auto count =
      std::count_if(scene.shapes.begin(), scene.shapes.end(), [&](const PlacedShape& placed) {
        return placed.material.valid() && !can_sample_surface(placed.shape) &&
               plan.materials[placed.material.index()].emission_source >= 0;
      });
  if (count > 0)
    plan.notes.push_back(
        fmt::format("{} {} by chance alone, since only squares, discs, spheres, "
                    "boxes and meshes can be aimed at",
                    count, count == 1 ? "shining shape is met" : "shining shapes are met"));
}

void note_faint_lights(const Scene& scene, Plan& plan) {
  for (const std::size_t number : lights_below_quantum(scene, plan.grid, plan.settings.observer))
    plan.notes.push_back(fmt::format(
        "light number {} is fainter than 2^-37 of the brightest: the picture does not show it",
        number));
}

/// Coordinates are doubles. Where a scene stands far from the origin they are coarse beside it.
void note_coarse_places(const Scene& scene, Plan& plan) {
  constexpr double kCoarse = 1e-7; // of the scene's size; a pixel of a large picture is 1e-4 of it
  const double size = scene_size(scene), farthest = farthest_coordinate(scene);
  const double rounding = farthest * kRoundoff;
  if (!(size > 0.0 && rounding > kCoarse * size)) return;
  plan.notes.push_back(fmt::format(
      "the scene is {:.0e} times its size away from the origin, where places are told apart by "
      "{:.0e} of it: move it nearer",
      farthest / size, rounding / size));
}

} // namespace

void note_content(const Scene& scene, Plan& plan) {
  const auto count = [](std::size_t n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
  };
  const auto glasses = static_cast<std::size_t>(
      std::count_if(plan.media.begin(), plan.media.end(),
                    [](const MediumPlan& m) { return !m.index.achromatic(); }));
  plan.notes.insert(plan.notes.begin(),
                    fmt::format("{}, {}, {} ({} dispersive)",
                                count(scene.shapes.size(), "shape", "shapes"),
                                count(scene.lights.size(), "light", "lights"),
                                count(scene.media.size(), "medium", "media"), glasses));
  const RenderSettings& settings = plan.settings;
  plan.notes.insert(
      plan.notes.begin(),
      fmt::format("{} x {} pixels in {}, {}; {} of {:.3g} nm", plan.window.width(),
                  plan.window.height(), count(plan.tiles.size(), "tile", "tiles"),
                  (settings.may_end_early() ? "at most " : "") +
                      count(static_cast<std::size_t>(settings.samples_per_pixel), "sample a pixel",
                            "samples a pixel") +
                      (settings.adaptive == AdaptiveSampling::on ? " in the mean" : ""),
                  count(static_cast<std::size_t>(settings.bands), "band", "bands"),
                  plan.grid.width_nm()));
  if (settings.noise > 0.0)
    plan.notes.push_back(
        fmt::format("each tile ends at an estimated relative error of {}", settings.noise));
  if (scene.environment)
    plan.notes.push_back(fmt::format("the environment is a picture of {} x {} pixels{}",
                                     scene.environment->width, scene.environment->height,
                                     plan.environment ? "" : ", all black"));
  note_lamps_met_by_chance(scene, plan);
  note_faint_lights(scene, plan);
  note_coarse_places(scene, plan);
  for (const Medium& medium : scene.media)
    if (!is_achromatic(medium.index))
      plan.notes.push_back(
          fmt::format("{}: n_d {:.5f}, V_d {:.2f}", medium.name.empty() ? "a medium" : medium.name,
                      refractive_index(medium.index, kLineD_nm), abbe_number(medium.index)));
  for (const Medium& medium : scene.media)
    if (medium.drops) plan.notes.push_back(note_of(*medium.drops));
  const bool refracts = std::any_of(plan.materials.begin(), plan.materials.end(),
                                    [](const MaterialPlan& m) { return m.facts().transmits; });
  if (!refracts)
    plan.notes.push_back("nothing refracts: no Fresnel, no fans");
  else if (glasses == 0)
    plan.notes.push_back("no medium disperses: bands never part, no fans");
  const auto empty = static_cast<std::size_t>(
      std::count_if(plan.tiles.begin(), plan.tiles.end(), [](const Tile& t) { return t.empty; }));
  if (empty > 0)
    plan.notes.push_back(fmt::format("{} of {} show the background alone: no rays there", empty,
                                     count(plan.tiles.size(), "tile", "tiles")));
}

} // namespace abbe
