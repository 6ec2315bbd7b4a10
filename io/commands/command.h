#pragma once

#include "io/commands/convert_command.h"
#include "io/commands/denoise_command.h"
#include "io/commands/develop_command.h"
#include "io/commands/diff_command.h"
#include "io/commands/glass_command.h"
#include "io/commands/info_command.h"
#include "io/commands/lens_command.h"
#include "io/commands/line_command.h"
#include "io/commands/list_command.h"
#include "io/commands/manual_command.h"
#include "io/commands/merge_command.h"
#include "io/commands/pixel_command.h"
#include "io/commands/plan_command.h"
#include "io/commands/preview_command.h"
#include "io/commands/region_command.h"
#include "io/commands/relight_command.h"
#include "io/commands/render_command.h"
#include "io/commands/selftest_command.h"
#include "io/commands/view_command.h"

#include <variant>

namespace abbe {

/// The command line itself was answered (help, version, a mistake), and the exit code is all that
/// is left to return.
struct Answered {
  int exit_code = 0;
};
[[nodiscard]] inline int run(const Answered& answered) {
  return answered.exit_code;
}

/// What the user asks for. A command is a file pair of this folder and a name here. Its type has
/// `kName` and `kHelp`; `add_options` adds what can be given to the command line, and `run` returns
/// the exit code of the program. Where it has a member `given`, it gets the names of all options
/// that were given.
using Command =
    std::variant<Answered, RenderCommand, MergeCommand, DevelopCommand, DenoiseCommand,
                 RelightCommand, ConvertCommand, PlanCommand, ListCommand, GlassCommand,
                 LensCommand, InfoCommand, PixelCommand, LineCommand, RegionCommand, DiffCommand,
                 ViewCommand, PreviewCommand, SelftestCommand, ManualCommand>;

} // namespace abbe
