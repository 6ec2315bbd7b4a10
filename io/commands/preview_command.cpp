#include "io/commands/preview_command.h"

#include "core/render/memory_need.h"
#include "core/render/worker_limit.h"
#include "io/commands/check_memory.h"
#include "io/commands/setting_options.h"
#include "io/console/exit_codes.h"
#include "io/console/interrupt.h"
#include "io/console/terminal.h"
#include "io/preview/preview_server.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <thread>

namespace abbe {
namespace {

/// Has the scene rendered anew when a file is saved, and ends the preview when the user wishes.
void watch_until_interrupted(FileWatch& files, PreviewBoard& board,
                             const std::atomic<bool>& interrupt) {
  constexpr double kSeconds = 0.05;
  while (!interrupt)
    if (files.wait(kSeconds)) board.wish([](PreviewWishes& wishes) { wishes.read_again = true; });
  board.end();
}

} // namespace

void add_options(CLI::App& app, PreviewCommand& command) {
  add_scene(app, command.scene.path, command.scene.strictness);
  app.add_option("--port", command.port, "Serve the page on this port (default: any free one)")
      ->check(CLI::Range(0, 65535).description(""))
      ->type_name("N");
  add_settings(app, command.scene.settings);
}

int run(const PreviewCommand& command) {
  const std::atomic<bool>& interrupt = interrupted();
  limit_workers(0);
  PreviewBoard board;
  FileWatch files;
  files.follow({command.scene.path});
  const PreviewServer server(board, command.port);
  say(fmt::format("preview of {}: {}", command.scene.path.string(), server.address()));
  say("only this machine can open it. Ctrl-C ends it");
  if (!all_was_said()) return kExitFailure; // at once: nobody could know the address
  const std::jthread watcher([&] { watch_until_interrupted(files, board, interrupt); });
  PreviewedScene previewed = command.scene;
  previewed.check_memory = [](const Scene& scene, const RenderSettings& settings) {
    check_memory(picture_needs(least_memory_need(settings)), {});
    check_memory(plan_needs(least_plan_need(scene, settings)), {});
  };
  run_preview(previewed, board, files);
  return 0;
}

} // namespace abbe
