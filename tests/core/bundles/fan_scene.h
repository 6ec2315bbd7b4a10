#pragma once

#include "core/bundles/extend.h"
#include "core/bundles/fan.h"
#include "core/cameras/camera.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "tests/render_text.h"

namespace abbe::test {

/// A fan at the first surface that one camera ray meets.
struct FanScene {
  Scene scene;
  Plan plan;
  World world;
  CameraRays camera;
  PathWavelengths wavelengths;
  Fan fan;
  Bundle bundle;
  RayCounts rays;

  FanScene(const std::string& text, const glm::dvec2& pixel)
      : scene(scene_from(text)), plan(make_plan(scene, scene.settings)),
        world(scene.shapes, farthest_coordinate(scene)),
        camera(scene.camera, scene.settings.width, scene.settings.height), wavelengths(plan),
        fan(plan, world, camera.pixel_angle()) {
    wavelengths.begin_path(0.5);
    bundle.bands = {plan.first_band, plan.last_band};
    bundle.state.ray = camera.ray(pixel);
    bundle.state.nesting = world.nesting_at(scene.camera.eye);
    world.find_closest(bundle.state, bundle.hit);
    bundle.traced = true;
  }
  FanScene(const FanScene&) = delete; // the fan refers to the plan
  FanScene& operator=(const FanScene&) = delete;

  const std::vector<FanCell>& refract(double choice = 0.5) {
    return fan.refract(bundle, bundle.bands, {1.0, choice}, wavelengths, rays);
  }
};

} // namespace abbe::test
