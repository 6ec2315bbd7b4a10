#include "io/commands/kept_state.h"

#include "core/render/film_layers.h"
#include "core/scene/user_error.h"
#include "io/console/terminal.h"
#include "io/states/kept_settings.h"

#include <fmt/format.h>

namespace abbe {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw UserError(fmt::format("{}: {}", file.string(), reason));
}

} // namespace

void check_origin(const fs::path& file, const StateInfo& info, const InputFiles& inputs) {
  if (info.version != program_version())
    refuse(file, fmt::format("abbe {} has written this state, and this is {}. Go on with that one",
                             info.version, program_version()));
  const std::vector<SceneFile> now = scene_files(inputs);
  if (now.size() != info.files.size())
    refuse(file, fmt::format("the scene was read from {} files then, and from {} now. It must be "
                             "the same",
                             info.files.size(), now.size()));
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i].size != info.files[i].size || now[i].checksum != info.files[i].checksum)
      refuse(file, fmt::format("{} is not what it was when the rendering began ({} bytes then, {} "
                               "now). The scene must be the same",
                               now[i].path.string(), info.files[i].size, now[i].size));
  if (info.build != build_checksum())
    say_warning(fmt::format("{}: another build of this program has written this state; the same "
                            "bytes are not promised",
                            file.string()));
}

void check_plan(const fs::path& file, const StateReader& state, const Scene& scene,
                const Plan& plan) {
  if (const std::string what = difference(state.info().settings, plan.settings); !what.empty())
    refuse(file, fmt::format("the settings differ: {}. Leave out what is not as it was", what));
  std::optional<BandPlace> bands;
  if (state.has_bands()) bands.emplace();
  if (state.window() != plan.window || !(state.layers() == film_layers(scene, plan, bands)) ||
      state.tiles() != plan.tiles.size())
    refuse(file, "its film is not that of this scene");
}

StateInfo info_of(const fs::path& scene, const InputFiles& inputs, const Plan& plan,
                  const RenderPart& part) {
  return {program_version(),
          build_checksum(),
          fs::absolute(scene).lexically_normal(),
          scene_files(inputs),
          kept_settings(plan.settings),
          plan.settings.samples_per_pixel,
          part};
}

} // namespace abbe
