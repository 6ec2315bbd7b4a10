#include "io/commands/convert_command.h"

#include "core/scene/user_error.h"
#include "io/commands/setting_options.h"
#include "io/console/terminal.h"
#include "io/converting/scene_writer.h"
#include "io/outputs/check_outputs.h"
#include "io/scene_files/read_scene_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace abbe {

void add_options(CLI::App& app, ConvertCommand& command) {
  add_scene(app, command.scene, command.strictness);
  app.add_option("output", command.output,
                 "The scene to be written (.sdl); meshes, spectra and pictures get its name with "
                 "an ending of their own")
      ->required()
      ->type_name("FILE");
}

int run(const ConvertCommand& command) {
  if (command.output.extension() != ".sdl")
    throw UserError(fmt::format("\"{}\" is no name of a scene of ours. It should end in .sdl",
                                command.output.string()));
  InputFiles inputs{command.scene};
  const Scene scene =
      read_scene_file(command.scene, say_warning, &inputs, nullptr, command.strictness);
  check_outputs({}, inputs, {{command.output}});
  SceneWriter(scene, command.output, say_warning).write();
  say(fmt::format("wrote {}", command.output.string()));
  return 0;
}

} // namespace abbe
