#pragma once

#include "core/bundles/bundle.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "tests/render_text.h"

namespace abbe::test {

/// A scene that bundles walk through.
struct WalkScene {
  Scene scene;
  Plan plan;
  World world;
  RayCounts counts;

  explicit WalkScene(const std::string& text, bool skip = true)
      : scene(scene_from(text)), plan(planned(scene, skip)),
        world(scene.shapes, farthest_coordinate(scene)) {}
  WalkScene(const WalkScene&) = delete; // walks refer to the plan
  WalkScene& operator=(const WalkScene&) = delete;

  /// A bundle of all bands of the plan that sets off from a place, untraced.
  [[nodiscard]] Bundle bundle_from(const dvec3& place, const dvec3& direction) const {
    Bundle bundle;
    bundle.bands = {plan.first_band, plan.last_band};
    bundle.state.ray = {place, glm::normalize(direction)};
    bundle.state.nesting = world.nesting_at(place);
    return bundle;
  }

private:
  static Plan planned(Scene& scene, bool skip) {
    scene.settings.skip = skip;
    return make_plan(scene, scene.settings);
  }
};

} // namespace abbe::test
