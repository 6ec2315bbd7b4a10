#include "io/commands/merge_command.h"

#include "core/render/render.h"
#include "io/commands/kept_state.h"
#include "io/commands/scene_request.h"
#include "io/commands/setting_options.h"
#include "io/console/exit_codes.h"
#include "io/console/progress.h"
#include "io/console/terminal.h"
#include "io/outputs/band_place.h"
#include "io/outputs/output_effects.h"
#include "io/outputs/output_names.h"
#include "io/outputs/write_outputs.h"
#include "io/states/check_parts.h"
#include "io/states/kept_settings.h"
#include "io/states/merge_states.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// What all parts say of themselves.
std::vector<KeptPart> parts_in(const std::vector<fs::path>& files,
                               const std::vector<StateReader>& readers) {
  std::vector<KeptPart> parts;
  for (std::size_t i = 0; i < files.size(); ++i)
    parts.push_back({files[i], readers[i].info(), readers[i].complete()});
  return parts;
}

/// The scene of the parts, with their settings.
SceneRequest scene_of(const MergeCommand& command, const StateInfo& info, InputFiles& inputs) {
  SceneRequest request = read_request(command.scene_path.value_or(info.scene), {}, &inputs,
                                      Strictness::lenient); // it has been rendered
  request.settings = with_kept(request.settings, info.settings, {});
  request.settings.samples_per_pixel = info.samples;
  return request;
}

} // namespace

void add_options(CLI::App& app, MergeCommand& command) {
  app.add_option("parts", command.parts, "All parts, in any order")->required()->type_name("PART");
  add_images(app, command.outputs, "")->required();
  app.add_option("--spectral", command.spectral_output,
                 "Write all bands into one EXR; the parts must have them")
      ->type_name("FILE");
  app.add_option("--scene", command.scene_path,
                 "The scene, where it is not where the first part was rendered")
      ->type_name("SCENE");
  add_settings(app, command.display);
  add_output_options(app, command.output);
  app.add_flag("-q,--quiet", command.quiet, "Print warnings and errors only");
}

int run(const MergeCommand& command) {
  outlive_readers();
  std::vector<StateReader> readers(command.parts.begin(), command.parts.end());
  const std::vector<KeptPart> parts = parts_in(command.parts, readers);
  check_parts(parts);
  const StateInfo& info = parts.front().info;
  InputFiles inputs;
  SceneRequest request = scene_of(command, info, inputs);
  check_origin(parts.front().file, info, inputs);
  for (const KeptPart& part : parts)
    if (part.info.build != info.build)
      say_warning(part.file.string() + ": another build of this program has rendered this part "
                                       "than the first; the same bytes are not promised");
  inputs.insert(inputs.end(), command.parts.begin(), command.parts.end());
  const Outputs outputs{command.outputs, command.spectral_output, {}};
  check_outputs(outputs, inputs);
  check_ocio(command.output);
  warn_of_outputs(command.given, outputs, command.output, say_warning);
  const Plan plan = plan_of(request, request.settings);
  check_outputs(outputs, inputs, further_files(request.scene, plan, outputs, command.output));
  if (command.spectral_output && !readers.front().has_bands())
    throw UserError("these parts have no bands: they are kept where parts are rendered with "
                    "--spectral");
  const BandPlace place = band_place(command.spectral_output.value_or(command.outputs.front()));
  for (std::size_t i = 0; i < parts.size(); ++i)
    check_plan(parts[i].file, readers[i], request.scene, plan);
  const Rendering rendering = end_rendering(merge_states(readers, place), plan, true);
  if (!command.quiet) say(summary(rendering));
  say_warning(light_warning(rendering));
  const DisplaySettings display = overridden(request.scene.display, command.display);
  return write_outputs({rendering, plan}, outputs, command.output, display, command.quiet)
             ? 0
             : kExitFailure;
}

} // namespace abbe
