#pragma once

#include "core/plan/plan.h"
#include "core/scene/scene.h"
#include "io/scene_language/input_files.h"
#include "io/states/read_state.h"

#include <filesystem>

namespace abbe {

// What a state that was kept in a file must have in common with what it is to go on as, or with
// the parts it is to be merged with. All throw UserError, which names the file and what differs.

/// The program's version and the scene's files. Warns of another build of the same version.
void check_origin(const std::filesystem::path& file, const StateInfo& info,
                  const InputFiles& inputs);

/// The settings, the layers and the pixels.
void check_plan(const std::filesystem::path& file, const StateReader& state, const Scene& scene,
                const Plan& plan);

/// What the state of a rendering is the state of.
[[nodiscard]] StateInfo info_of(const std::filesystem::path& scene, const InputFiles& inputs,
                                const Plan& plan, const RenderPart& part);

} // namespace abbe
