#include "io/commands/render_command.h"

#include "core/image/develop.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/memory_need.h"
#include "core/render/render.h"
#include "core/render/worker_limit.h"
#include "io/commands/check_memory.h"
#include "io/commands/scene_request.h"
#include "io/commands/setting_options.h"
#include "io/console/exit_codes.h"
#include "io/console/interrupt.h"
#include "io/console/progress.h"
#include "io/console/terminal.h"
#include "io/outputs/output_effects.h"
#include "io/outputs/picture_warnings.h"
#include "io/outputs/write_outputs.h"
#include "io/text/numbers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>

namespace abbe {
namespace {

namespace fs = std::filesystem;

void add_memory_limit(CLI::App& app, std::optional<double>& limit_gib) {
  const auto give = [&limit_gib](const std::string& text) {
    const auto gib = parse_finite(text);
    if (!gib || !(*gib > 0.0) || *gib > 1e6)
      throw CLI::ValidationError("--limit-memory", "\"" + text + "\" is not a size in GiB above 0");
    limit_gib = gib;
  };
  app.add_option_function<std::string>(
         "--limit-memory", give,
         "Do not begin a picture that needs more memory (default: what the machine has left)")
      ->type_name("GIB");
}

void warn_unless_empty(const std::string& message) {
  if (!message.empty()) say_warning(message);
}

Outputs outputs_of(const RenderCommand& command, const Scene& scene) {
  Outputs outputs{command.outputs, command.spectral_output};
  if (outputs.images.empty()) outputs.images = {scene.title + ".exr", scene.title + ".tiff"};
  return outputs;
}

/// Where the sums of all bands go when they are large.
BandPlace band_place(const fs::path& spectral) {
  if (const char* folder = std::getenv("TMPDIR"); folder != nullptr && *folder != '\0')
    return {folder};
  return {spectral.has_parent_path() ? spectral.parent_path() : "."};
}

/// The settings with as many threads as the system allows.
RenderSettings with_allowed_threads(RenderSettings settings, const Workers& workers) {
  if (workers.allowed >= workers.wanted) return settings;
  say_warning(fmt::format("the system allows {} of {} threads", workers.allowed, workers.wanted));
  settings.threads = workers.allowed;
  return settings;
}

bool has_samples(const Film& film) {
  bool some = false;
  for_each_pixel(film.window(), [&](int x, int y) { some = some || film.samples(x, y) > 0; });
  return some;
}

/// Keeps what was done of a rendering that was stopped, and returns the exit code.
int write_partial(const Rendering& rendering, const Plan& plan, const Outputs& outputs,
                  const OutputOptions& options) {
  if (!has_samples(rendering.film)) {
    say_error("interrupted before the first samples were done: there is no picture");
    return kExitInterrupted;
  }
  const fs::path partial = partial_path(outputs);
  write_image(partial, develop_scene_linear(rendering.film, plan, options.exr_space), {}, options);
  say_error("interrupted: what was done is in " + partial.string());
  return kExitInterrupted;
}

} // namespace

void add_options(CLI::App& app, RenderCommand& command) {
  add_scene(app, command.scene_path);
  app.add_option("-o,--output", command.outputs,
                 "Picture to write (" + known_image_extensions() +
                     "); may be repeated. Default: NAME.exr and NAME.tiff in this folder")
      ->type_name("FILE");
  app.add_option("--spectral", command.spectral_output, "Write all bands into one EXR")
      ->type_name("FILE");
  add_settings(app, command.display);
  add_output_options(app, command.output);
  add_memory_limit(app, command.memory_limit_gib);
  app.add_flag("-q,--quiet", command.quiet, "Print warnings and errors only");
  add_settings(app, command.settings);
}

int run(const RenderCommand& command) {
  outlive_readers();
  const std::atomic<bool>& stop = interrupted();
  InputFiles inputs;
  const SceneRequest request = read_request(command.scene_path, command.settings, &inputs);
  const Scene& scene = request.scene;
  const Outputs outputs = outputs_of(command, scene);
  check_outputs(outputs, inputs);
  warn_of_outputs(command.given, outputs, command.output, say_warning);
  check_memory(least_memory_need(request.settings), command.memory_limit_gib);
  const Workers workers = limit_workers(request.settings.threads);
  const Plan plan = make_plan(scene, with_allowed_threads(request.settings, workers));
  std::optional<BandPlace> bands;
  if (outputs.spectral) bands = band_place(*outputs.spectral);
  check_memory(memory_need(scene, plan, bands), command.memory_limit_gib);
  if (!command.quiet) tell_plan(plan);
  const World world(scene.shapes, farthest_coordinate(scene));

  Progress progress(command.quiet);
  const Rendering rendering =
      render(scene, plan, world, bands,
             {.progress = [&](const RenderProgress& p) { progress.tell(p); }, .stop = &stop});
  progress.finish();
  if (!command.quiet) say(summary(rendering));
  warn_unless_empty(light_warning(rendering));

  if (!rendering.complete) return write_partial(rendering, plan, outputs, command.output);
  warn_unless_empty(warning_of_darkness(scene, plan, rendering));
  const DisplaySettings display = overridden(scene.display, command.display);
  return write_outputs(rendering, plan, outputs, command.output, display, command.quiet)
             ? 0
             : kExitFailure;
}

} // namespace abbe
