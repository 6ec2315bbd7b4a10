#include "io/commands/render_command.h"

#include "core/image/develop.h"
#include "core/planning/plan_extent.h"
#include "core/render/memory_need.h"
#include "core/render/peer_sums.h"
#include "core/render/render.h"
#include "core/render/worker_limit.h"
#include "io/commands/check_memory.h"
#include "io/commands/checkpoints.h"
#include "io/commands/kept_state.h"
#include "io/commands/pilot.h"
#include "io/commands/scene_request.h"
#include "io/commands/setting_options.h"
#include "io/console/exit_codes.h"
#include "io/console/interrupt.h"
#include "io/console/progress.h"
#include "io/console/terminal.h"
#include "io/outputs/band_place.h"
#include "io/outputs/display_server.h"
#include "io/outputs/output_effects.h"
#include "io/outputs/output_names.h"
#include "io/outputs/picture_warnings.h"
#include "io/outputs/write_film_exr.h"
#include "io/outputs/write_outputs.h"
#include "io/text/numbers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <utility>

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

Outputs outputs_of(const RenderCommand& command, const Scene& scene, const RenderPart& part) {
  if (command.states.plan_out) {
    if (!command.outputs.empty() || command.spectral_output)
      throw UserError("--plan-out writes a plan and no picture. Leave out -o and --spectral");
    return {{}, {}, command.states.plan_out};
  }
  if (!part.is_whole()) {
    if (command.outputs.size() != 1)
      throw UserError("a part goes into one file. Name it with -o, such as -o part3.state");
    if (is_known_image_extension(command.outputs.front()))
      throw UserError(fmt::format("{}: a part is a state and no picture. Name it otherwise, such "
                                  "as part3.state",
                                  command.outputs.front().string()));
    if (command.states.checkpoint)
      throw UserError("a part is kept now and then in its own file. Leave out --checkpoint");
    return {{}, {}, command.outputs.front()};
  }
  Outputs outputs{command.outputs, command.spectral_output, command.states.checkpoint};
  if (outputs.images.empty()) outputs.images = {scene.title + ".exr", scene.title + ".tiff"};
  return outputs;
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

/// Writes a picture of what was done of a rendering that was stopped, and returns the exit code.
int write_partial(const Rendering& rendering, const Plan& plan, const Outputs& outputs,
                  const OutputOptions& options) {
  if (!has_samples(rendering.film)) {
    say_error("interrupted before the first samples were done: there is no picture");
    return kExitInterrupted;
  }
  const fs::path partial = partial_path(outputs);
  (void)FilmExrs(rendering.film, plan, options).write_picture(partial);
  say_error("interrupted: what was done is in " + partial.string());
  return kExitInterrupted;
}

} // namespace

void add_options(CLI::App& app, RenderCommand& command) {
  add_scene(app, command.scene_path, command.strictness);
  app.get_option("scene")->required(false);
  app.callback([&command] {
    if (command.scene_path.empty() && !command.states.resume) throw CLI::RequiredError("scene");
  });
  add_images(app, command.outputs, ". Default: NAME.exr and NAME.tiff in this folder");
  app.add_option("--spectral", command.spectral_output, "Write all bands into one EXR")
      ->type_name("FILE");
  add_settings(app, command.display);
  add_output_options(app, command.output);
  add_memory_limit(app, command.memory_limit_gib);
  add_state_options(app, command.states);
  app.add_flag("--denoise", command.output.denoise,
               "Take the noise out of pictures and bands by what else is known of their pixels");
  app.add_option_function<std::string>(
         "--display-server",
         [&command](const std::string& place) { command.display_server = place; },
         "Show the picture as it grows in tev, or another viewer that listens there")
      ->type_name("HOST:PORT");
  app.add_flag("-q,--quiet", command.quiet, "Print warnings and errors only");
  add_settings(app, command.settings);
}

namespace {

/// A scene with its settings, and where its rendering begins.
struct Request {
  InputFiles inputs;
  std::optional<StateReader> resumed;
  std::filesystem::path scene_path;
  SceneRequest scene;
  RenderPart part;
};

Request read_request(const RenderCommand& command) {
  Request request;
  const StateOptions& states = command.states;
  if (states.resume) request.resumed.emplace(*states.resume);
  const StateReader* resumed = request.resumed ? &*request.resumed : nullptr;
  request.part = part_of(states, resumed);
  request.scene_path = command.scene_path.empty() ? resumed->info().scene : command.scene_path;
  // A scene that has been rendered is read again, whether it was read strictly then or not.
  request.scene = read_request(request.scene_path, command.settings, &request.inputs,
                               resumed ? Strictness::lenient : command.strictness);
  if (!resumed) return request;
  check_origin(*states.resume, resumed->info(), request.inputs);
  request.scene.settings =
      resumed_settings(*states.resume, resumed->info(), request.scene.settings, command.settings);
  return request;
}

/// Where the film's sums go where they are large, and whether it keeps the bands of each pixel.
BandPlace bands_of(const RenderCommand& command, const Request& request, const Outputs& outputs) {
  const bool kept = request.resumed && request.resumed->has_bands();
  if (request.resumed && command.spectral_output && !kept)
    throw UserError(fmt::format("{}: this state has no bands. They are kept where a rendering is "
                                "begun with --spectral",
                                command.states.resume->string()));
  std::filesystem::path beside = command.spectral_output.value_or(std::filesystem::path());
  if (beside.empty() && !outputs.images.empty()) beside = outputs.images.front();
  if (beside.empty() && outputs.state) beside = *outputs.state;
  BandPlace place = band_place(beside);
  place.spectra = command.spectral_output || kept;
  return place;
}

/// What the command line says that peers cannot do is refused.
void check_peers(const Peers& peers, const RenderCommand& command, const Request& request) {
  if (peers.alone()) return;
  if (!request.part.is_whole())
    throw UserError("--part and MPI exclude each other: its ranks divide the work already. Leave "
                    "out --part");
  if (request.scene.settings.seconds > 0.0)
    throw UserError("--time and MPI exclude each other: ranks have clocks of their own. Give the "
                    "samples by --spp");
  if (command.display_server)
    throw UserError("--display-server and MPI exclude each other: no rank has the whole picture "
                    "before the end. Leave out --display-server");
  if (command.states.plan_out)
    throw UserError("--plan-out makes a plan by one process. Use abbe without MPI");
}

/// Asks for the layers that the filter goes by.
void prepare_denoising(Request& request, const Outputs& outputs) {
  if (outputs.images.empty())
    throw UserError("--denoise is for pictures, and this writes none. Render parts with --layers "
                    "denoise, and give what abbe merge makes of them to abbe denoise");
  RenderSettings& settings = request.scene.settings;
  if (settings.samples_per_pixel < 2)
    throw UserError("--denoise needs two samples per pixel, which tell how noisy it is. Give --spp "
                    "2 or more");
  const ExtraLayers before = settings.layers;
  (void)add_layers("denoise", settings.layers);
  if (request.resumed && settings.layers != before)
    throw UserError("this state has no layers for --denoise. They are kept where a rendering is "
                    "begun with --denoise, or --layers denoise");
}

RenderState begin(const RenderCommand& command, Request& request, const Plan& plan,
                  const BandPlace& bands, const Peers& peers) {
  const Scene& scene = request.scene.scene;
  if (!request.resumed) return begin_rendering(scene, plan, bands, request.part);
  const std::filesystem::path& file = *command.states.resume;
  check_plan(file, *request.resumed, scene, plan);
  RenderState state = request.resumed->read_share(bands, plan, peers);
  if (!command.quiet) say(resume_note(file, request.resumed->info(), state, plan));
  return state;
}

/// The viewer that shows a rendering as it grows, if the user has named one.
class Viewer {
public:
  Viewer(const RenderCommand& command, const Outputs& outputs, const Plan& plan)
      : plan_(plan), space_(command.output.exr_space) {
    if (!command.display_server) return;
    const fs::path& file = outputs.images.empty() ? *outputs.state : outputs.images.front();
    server_.emplace(*command.display_server, file.filename().string());
  }

  /// Empty where there is no viewer.
  [[nodiscard]] std::function<void(const RenderState&)> watch() {
    if (!server_) return {};
    return [this](const RenderState& state) { show(state); };
  }
  void show(const RenderState& state) {
    if (!server_ || server_->show(develop_scene_linear(state.film, plan_, space_))) return;
    say_warning("the viewer has gone, or takes no more; the rendering goes on");
    server_.reset();
  }

private:
  const Plan& plan_;
  SceneLinearSpace space_;
  std::optional<DisplayServer> server_;
};

/// Tells where the state is that a rendering leaves, or that there is none.
void tell_state(const Outputs& outputs, const CheckpointedRender& done, bool quiet) {
  if (!outputs.state || !done.kept) return;
  if (!done.complete)
    say_error(fmt::format("interrupted: --resume {} goes on", outputs.state->string()));
  else if (!quiet)
    say("wrote " + outputs.state->string());
}

} // namespace

int run(const RenderCommand& command) {
  return run(command, {});
}

int run(const RenderCommand& command, const Peers& peers) {
  outlive_readers();
  const std::atomic<bool>& stop = interrupted();
  Request request = read_request(command);
  const Scene& scene = request.scene.scene;
  check_peers(peers, command, request);
  const Outputs outputs = outputs_of(command, scene, request.part);
  const ExtraLayers asked = request.scene.settings.layers;
  if (command.output.denoise) prepare_denoising(request, outputs);
  if (peers.is_first()) check_outputs(outputs, request.inputs);
  const DisplaySettings display = overridden(scene.display, command.display);
  check_ocio(command.output);
  warn_of_outputs(command.given, outputs, command.output, say_warning);
  warn_of_adaptation(command.given, outputs, display, say_warning);
  check_memory(picture_needs(least_memory_need(request.scene.settings)), command.memory_limit_gib);
  check_memory(plan_needs(least_plan_need(scene, request.scene.settings)),
               command.memory_limit_gib);
  const Workers workers = limit_workers(request.scene.settings.threads);
  const Plan plan = plan_of(request.scene, with_allowed_threads(request.scene.settings, workers));
  check_plan_options(command.states, plan.settings);
  check_part(request.part, plan.settings,
             command.states.plan_in || (request.resumed && is_planned(request.resumed->info())));
  if (peers.is_first())
    check_outputs(outputs, request.inputs, further_files(scene, plan, outputs, command.output));
  const BandPlace bands = bands_of(command, request, outputs);
  check_memory(picture_needs(memory_need(scene, plan, bands)), command.memory_limit_gib);
  if (!command.quiet) {
    tell_plan(plan);
    tell_disk(disk_need(scene, plan, bands), bands);
  }
  StateInfo info; // the checksums in it take time, so it is there where a state is kept
  if (outputs.state) info = info_of(request.scene_path, request.inputs, plan, request.part);
  if (command.states.plan_out)
    return write_pilot(*outputs.state, scene, plan, info, stop, command.quiet) ? 0
                                                                               : kExitInterrupted;
  RenderState state = begin(command, request, plan, bands, peers);
  if (command.states.plan_in) {
    Spread spread = read_spread(*command.states.plan_in, plan, request.inputs);
    spread_samples(state, std::move(spread.shares), plan.settings.samples_per_pixel);
    info.settings.push_back(std::move(spread.setting));
  }
  if (request.resumed && is_planned(request.resumed->info()))
    info.settings = request.resumed->info().settings;
  const World world(scene.shapes, farthest_coordinate(scene));
  Viewer viewer(command, outputs, plan);
  if (!peers.all(true)) return kPeerFailed;

  const SampleRange range = samples_of(request.part, plan.settings.samples_per_pixel);
  const CheckpointedRender done = render_with_checkpoints(
      {scene, plan, world, info, peers, viewer.watch()}, range, state,
      {outputs.state, command.states.every_seconds, bands}, stop, command.quiet);
  viewer.show(state);
  add_up_film(state.film, peers);
  if (!peers.is_first()) return done.complete ? 0 : kExitInterrupted;
  const Rendering rendering = end_rendering(std::move(state), plan, done.complete);
  if (!command.quiet) say(summary(rendering));
  tell_state(outputs, done, command.quiet);
  if (outputs.images.empty())
    return !done.complete ? kExitInterrupted : done.kept ? 0 : kExitFailure;
  say_warning(light_warning(rendering));

  if (!rendering.complete) return write_partial(rendering, plan, outputs, command.output);
  say_warning(warning_of_darkness(scene, plan, rendering));
  std::optional<DenoisedPictures> denoised;
  if (command.output.denoise) denoised.emplace(rendering.film, plan, asked);
  const bool written = write_outputs({rendering, plan, denoised ? &*denoised : nullptr}, outputs,
                                     command.output, display, command.quiet);
  return written && done.kept ? 0 : kExitFailure;
}

} // namespace abbe
