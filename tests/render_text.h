#pragma once

#include "core/plan/plan.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/render.h"
#include "io/scene_language/read_scene.h"

#include <optional>
#include <string>

namespace abbe::test {

/// Every pixel gets the same number of samples: tests know what a sample is, and how many there
/// are. Those of adaptive sampling ask for it.
inline Scene evenly_sampled(Scene scene) {
  scene.settings.adaptive = AdaptiveSampling::off;
  return scene;
}

/// A scene from text, evenly sampled. Warnings are dropped.
inline Scene scene_from(const std::string& text) {
  return evenly_sampled(read_scene_text(text, "test.sdl", [](const std::string&) {}));
}

/// One of the project's scenes, evenly sampled, small: `size` pixels per side.
inline Scene project_scene(const std::string& name, int size) {
  Scene scene = evenly_sampled(read_scene(std::string(ABBE_SOURCE_DIR) + "/scenes/" + name + ".sdl",
                                          [](const std::string&) {}));
  scene.settings.width = scene.settings.height = size;
  scene.settings.crop.reset();
  return scene;
}

inline Rendering render_scene(const Scene& scene, bool keep_bands) {
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  return render(scene, plan, world,
                keep_bands ? std::optional<BandPlace>(BandPlace{}) : std::nullopt);
}

} // namespace abbe::test
