#include "io/commands/pilot.h"

#include "core/adaptive/sample_shares.h"
#include "core/planning/plan_extent.h"
#include "core/render/render.h"
#include "core/scene/user_error.h"
#include "io/commands/kept_state.h"
#include "io/console/progress.h"
#include "io/states/kept_settings.h"
#include "io/states/plan_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace abbe {
namespace {

/// As many samples tell where the next ones are needed; docs/decisions/noise.md.
constexpr int kMostPilots = 16;

} // namespace

bool write_pilot(const std::filesystem::path& file, const Scene& scene, const Plan& plan,
                 const StateInfo& info, const std::atomic<bool>& stop, bool quiet) {
  Plan pilot = plan;
  ++pilot.settings.seed;
  const int samples = std::min(SampleSchedule(plan.settings).end_of_round(0), kMostPilots);
  RenderState state = begin_rendering(scene, pilot);
  const World world(scene.shapes, farthest_coordinate(scene));
  Progress progress(quiet);
  const auto tell = [&](const RenderProgress& now) { progress.tell(now); };
  if (!render(scene, pilot, world, {0, samples}, state, {.progress = tell, .stop = &stop}))
    return false;
  progress.finish();
  write_plan_file(file, {info, plan.window, find_shares(state.film, state.pixel_rays)});
  return true;
}

Spread read_spread(const std::filesystem::path& file, const Plan& plan, const InputFiles& inputs) {
  PlanFile read = read_plan_file(file);
  check_origin(file, read.info, inputs);
  if (const std::string what = difference(read.info.settings, plan.settings); !what.empty())
    throw UserError(fmt::format("{}: the settings differ from those of the plan: {}. Leave out "
                                "what is not as it was",
                                file.string(), what));
  if (read.window != plan.window || read.shares.size() != plan.window.pixel_count())
    throw UserError(file.string() + ": this plan is of other pixels");
  return {std::move(read.shares), {kPlanOption, fmt::format("{:08x}", read.checksum)}};
}

} // namespace abbe
