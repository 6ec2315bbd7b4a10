#include "io/commands/plan_command.h"

#include "core/planning/make_plan.h"
#include "core/render/memory_need.h"
#include "io/commands/check_memory.h"
#include "io/commands/scene_request.h"
#include "io/commands/setting_options.h"

namespace abbe {

void add_options(CLI::App& app, PlanCommand& command) {
  add_scene(app, command.scene_path);
  add_settings(app, command.settings);
}

int run(const PlanCommand& command) {
  const SceneRequest request = read_request(command.scene_path, command.settings, nullptr);
  check_memory(plan_needs(least_plan_need(request.scene, request.settings)), {});
  tell_plan(make_plan(request.scene, request.settings));
  return 0;
}

} // namespace abbe
