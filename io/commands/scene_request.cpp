#include "io/commands/scene_request.h"

#include "io/building/setting_effects.h"
#include "io/console/terminal.h"
#include "io/scene_files/read_scene_file.h"

namespace abbe {

SceneRequest read_request(const std::filesystem::path& scene_path, const SettingsOverride& settings,
                          InputFiles* inputs) {
  GivenKeywords given;
  Scene scene = read_scene_file(scene_path, say_warning, inputs, &given);
  const RenderSettings asked = overridden(scene.settings, settings);
  check_caustics(given, asked);
  warn_of_settings(scene, given, settings, say_warning);
  return {std::move(scene), asked};
}

void tell_plan(const Plan& plan) {
  for (const std::string& note : plan.notes)
    say("plan: " + note);
}

} // namespace abbe
