#pragma once

#include "core/adaptive/render_part.h"
#include "core/plan/plan.h"
#include "io/settings/setting_text.h"
#include "io/states/read_state.h"

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace abbe {

/// What the command line says of states: where they are kept, and from which one to go on.
struct StateOptions {
  std::optional<std::filesystem::path> checkpoint, resume;
  double every_seconds = 600.0; ///< a state is kept
  std::optional<RenderPart> part;
  /// Where the plan goes of how samples are spread, and where it comes from.
  std::optional<std::filesystem::path> plan_out, plan_in;
};
void add_state_options(CLI::App& app, StateOptions& options);

/// The part to render: the one that was asked for, else that of the state from which the rendering
/// goes on, else all. Throws UserError where these differ.
[[nodiscard]] RenderPart part_of(const StateOptions& options, const StateReader* resumed);

/// Throws UserError for a plan that cannot be rendered in parts. `spread`: a plan file tells where
/// samples go.
void check_part(const RenderPart& part, const RenderSettings& settings, bool spread);

/// Throws UserError where a plan file does not go with what else is asked for.
void check_plan_options(const StateOptions& options, const RenderSettings& settings);

/// The settings with which a rendering goes on: the state's, but more samples where they are
/// `given`. Throws UserError for fewer samples.
[[nodiscard]] RenderSettings resumed_settings(const std::filesystem::path& file,
                                              const StateInfo& info, const RenderSettings& settings,
                                              const SettingsOverride& given);

/// Tells how far the state is, and whether a picture that gets more samples than it was begun for
/// will have the bytes of one that was begun for as many.
[[nodiscard]] std::string resume_note(const std::filesystem::path& file, const StateInfo& info,
                                      const RenderState& state, const Plan& plan);

} // namespace abbe
