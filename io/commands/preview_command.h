#pragma once

#include "io/preview/preview_loop.h"

namespace CLI {
class App;
}

namespace abbe {

/// Shows a scene in a browser while it is being written.
struct PreviewCommand {
  static constexpr const char* kName = "preview";
  static constexpr const char* kHelp = "Show a scene in the browser, anew each time it is saved";

  PreviewedScene scene;
  int port = 0; ///< 0: any that is free
};
void add_options(CLI::App& app, PreviewCommand& command);
[[nodiscard]] int run(const PreviewCommand& command);

} // namespace abbe
