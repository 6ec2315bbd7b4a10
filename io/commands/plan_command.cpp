#include "io/commands/plan_command.h"

#include "core/render/memory_need.h"
#include "io/commands/check_memory.h"
#include "io/commands/scene_request.h"
#include "io/commands/setting_options.h"
#include "io/outputs/band_place.h"

namespace abbe {

void add_options(CLI::App& app, PlanCommand& command) {
  add_scene(app, command.scene_path, command.strictness);
  add_settings(app, command.settings);
}

int run(const PlanCommand& command) {
  SceneRequest request =
      read_request(command.scene_path, command.settings, nullptr, command.strictness);
  check_memory(plan_needs(least_plan_need(request.scene, request.settings)), {});
  const Plan plan = plan_of(request, request.settings);
  tell_plan(plan);
  BandPlace place = band_place({});
  place.spectra = false;
  tell_disk(disk_need(request.scene, plan, place), place);
  return 0;
}

} // namespace abbe
