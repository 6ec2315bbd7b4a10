#include "io/commands/scene_request.h"

#include "core/planning/make_plan.h"
#include "core/planning/plan_relightable.h"
#include "io/building/setting_effects.h"
#include "io/console/terminal.h"
#include "io/scene_files/read_scene_file.h"

#include <utility>

namespace abbe {

SceneRequest read_request(const std::filesystem::path& scene_path, const SettingsOverride& settings,
                          InputFiles* inputs, Strictness strictness) {
  GivenKeywords given;
  Scene scene = read_scene_file(scene_path, say_warning, inputs, &given, strictness);
  const RenderSettings asked = overridden(scene.settings, settings);
  check_caustics(given, asked);
  warn_of_settings(scene, given, settings, say_warning);
  return {std::move(scene), asked};
}

Plan plan_of(SceneRequest& request, const RenderSettings& settings) {
  if (!settings.relightable) return make_plan(request.scene, settings);
  if (!request.with_own_lamps) {
    request.with_own_lamps = std::move(request.scene);
    request.scene = equal_energy_scene(*request.with_own_lamps);
  }
  return plan_relightable(*request.with_own_lamps, request.scene, settings);
}

void tell_plan(const Plan& plan) {
  for (const std::string& note : plan.notes)
    say("plan: " + note);
}

} // namespace abbe
