#include "core/image/develop.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/memory_need.h"
#include "core/render/render.h"
#include "core/render/worker_limit.h"
#include "core/scene/user_error.h"
#include "io/images/write_exr.h"
#include "io/images/write_image.h"
#include "io/program/check_memory.h"
#include "io/program/check_outputs.h"
#include "io/program/command_line.h"
#include "io/program/interrupt.h"
#include "io/program/list.h"
#include "io/program/output_effects.h"
#include "io/program/picture_warnings.h"
#include "io/program/progress.h"
#include "io/program/terminal.h"
#include "io/program/write_each.h"
#include "io/scene_files/read_scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace abbe;
namespace fs = std::filesystem;

void print_warning(const std::string& message) {
  say_error("warning: " + message);
}

void warn_unless_empty(const std::string& message) {
  if (!message.empty()) print_warning(message);
}

void print_plan(const Plan& plan) {
  for (const std::string& note : plan.notes)
    say("plan: " + note);
}

Outputs outputs_of(const Options& options, const Scene& scene) {
  Outputs outputs{options.outputs, options.spectral_output};
  if (outputs.images.empty()) outputs.images = {scene.title + ".exr", scene.title + ".tiff"};
  return outputs;
}

/// Where the sums of all bands go when they are large.
BandPlace band_place(const fs::path& spectral) {
  if (const char* folder = std::getenv("TMPDIR"); folder != nullptr && *folder != '\0')
    return {folder};
  return {spectral.has_parent_path() ? spectral.parent_path() : "."};
}

/// The picture for screens, with a warning where it shows nothing of a film that is not black.
DisplayImage display_picture(const Rendering& rendering, const Plan& plan,
                             const DisplaySettings& settings) {
  DisplayImage image = develop_display(rendering.film, plan, settings);
  warn_unless_empty(warning_of_exposure(rendering.film, image));
  return image;
}

/// Each kind of picture is there only while its files are written. Returns false when some file
/// could not be written; the others are.
bool write_outputs(const Rendering& rendering, const Plan& plan, const Options& options,
                   const DisplaySettings& display_settings, const std::vector<fs::path>& outputs) {
  const auto write_all = [&](bool scene_linear, const SceneLinearImage& linear,
                             const DisplayImage& display) {
    std::vector<OutputJob> jobs;
    for (const fs::path& path : outputs)
      if (is_scene_linear_extension(path) == scene_linear)
        jobs.push_back(
            {path, [&, path] { return write_image(path, linear, display, options.output); }});
    return write_each(jobs, options.quiet);
  };
  bool all = true;
  if (std::ranges::any_of(outputs, is_scene_linear_extension))
    all = write_all(true, develop_scene_linear(rendering.film, plan, options.output.exr_space), {});
  if (!std::ranges::all_of(outputs, is_scene_linear_extension))
    all = write_all(false, {}, display_picture(rendering, plan, display_settings)) && all;
  if (!options.spectral_output) return all;
  const auto write_spectral = [&] {
    write_spectral_exr(
        *options.spectral_output, rendering.film.window(),
        [&](const PixelWindow& rows) { return develop_spectral(rendering.film, plan, rows); });
    return std::string();
  };
  return write_each({{*options.spectral_output, write_spectral}}, options.quiet) && all;
}

bool has_samples(const Film& film) {
  bool some = false;
  for_each_pixel(film.window(), [&](int x, int y) { some = some || film.samples(x, y) > 0; });
  return some;
}

/// What the command line asks for: a scene and its settings, checked and warned of.
struct Request {
  Scene scene;
  RenderSettings settings;
};

/// All files that are read are added to `inputs`, unless it is null.
Request read_request(const Options& options, InputFiles* inputs) {
  GivenKeywords given;
  Scene scene = read_scene_file(options.scene_path, print_warning, inputs, &given);
  const RenderSettings settings = overridden(scene.settings, options.settings);
  check_caustics(given, settings);
  warn_of_settings(scene, given, options.settings, print_warning);
  return {std::move(scene), settings};
}

int render_command(const Options& options) {
  outlive_readers();
  const std::atomic<bool>& stop = interrupted();
  InputFiles inputs;
  const Request request = read_request(options, &inputs);
  const Scene& scene = request.scene;
  const Outputs all_outputs = outputs_of(options, scene);
  check_outputs(all_outputs, inputs);
  warn_of_outputs(options, all_outputs, print_warning);
  const std::vector<fs::path>& outputs = all_outputs.images;
  RenderSettings settings = request.settings;
  check_memory(least_memory_need(settings), options.memory_limit_gib);
  const Workers workers = limit_workers(settings.threads);
  if (workers.allowed < workers.wanted) {
    print_warning(
        fmt::format("the system allows {} of {} threads", workers.allowed, workers.wanted));
    settings.threads = workers.allowed;
  }
  const Plan plan = make_plan(scene, settings);
  std::optional<BandPlace> bands;
  if (options.spectral_output) bands = band_place(*options.spectral_output);
  check_memory(memory_need(scene, plan, bands), options.memory_limit_gib);
  if (!options.quiet) print_plan(plan);
  const World world(scene.shapes, farthest_coordinate(scene));

  Progress progress(options.quiet);
  const Rendering rendering =
      render(scene, plan, world, bands,
             {.progress = [&](const RenderProgress& p) { progress.tell(p); }, .stop = &stop});
  progress.finish();
  if (!options.quiet) say(summary(rendering));
  if (const std::string warning = light_warning(rendering); !warning.empty())
    print_warning(warning);

  if (!rendering.complete) {
    if (!has_samples(rendering.film)) {
      say_error("interrupted before the first samples were done: there is no picture");
      return kExitInterrupted;
    }
    const fs::path partial = partial_path(all_outputs);
    write_image(partial, develop_scene_linear(rendering.film, plan, options.output.exr_space), {},
                options.output);
    say_error("interrupted: what was done is in " + partial.string());
    return kExitInterrupted;
  }
  warn_unless_empty(warning_of_darkness(scene, plan, rendering));
  const DisplaySettings display = overridden(scene.display, options.display);
  return write_outputs(rendering, plan, options, display, outputs) ? 0 : kExitFailure;
}

int plan_command(const Options& options) {
  const Request request = read_request(options, nullptr);
  print_plan(make_plan(request.scene, request.settings));
  return 0;
}

int run(const Options& options) {
  switch (options.command) {
  case Command::render:
    return render_command(options);
  case Command::plan:
    return plan_command(options);
  case Command::list:
    list(options);
    return 0;
  case Command::done:
    return options.exit_code;
  }
  return kExitFailure;
}

int run_and_tell(int argc, char** argv) {
  try {
    return run(parse_command_line(argc, argv));
  } catch (const ReadError& error) {
    say_error(error.what());
    return kExitUsage;
  } catch (const UserError& error) {
    say_error(fmt::format("abbe: {}", error.what()));
    return kExitUsage;
  } catch (const std::logic_error& error) { // no input should get here
    say_error(fmt::format("abbe: internal error: {}", error.what()));
    return kExitFailure;
  } catch (const std::exception& error) {
    say_error(fmt::format("abbe: {}", error.what()));
    return kExitFailure;
  }
}

} // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  const int code = run_and_tell(argc, argv);
  if (all_was_said()) return code;
  say_error("abbe: standard output cannot be written");
  return code == 0 ? kExitFailure : code;
}
