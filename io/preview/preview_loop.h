#pragma once

#include "core/scene/scene.h"
#include "io/building/strictness.h"
#include "io/files/file_watch.h"
#include "io/preview/preview_board.h"
#include "io/settings/setting_text.h"

#include <filesystem>
#include <functional>

namespace abbe {

/// What is previewed.
struct PreviewedScene {
  std::filesystem::path path;
  SettingsOverride settings; ///< of the command line
  Strictness strictness = Strictness::strict;
  /// Throws UserError where a rendering at these settings would take more memory than there is.
  std::function<void(const Scene&, const RenderSettings&)> check_memory;
};

/// Renders a scene again and again, as it and what is wished change, until the board says that the
/// preview is to end. Each time a coarse picture comes first. The files that the scene is read from
/// are watched from then on.
void run_preview(const PreviewedScene& previewed, PreviewBoard& board, FileWatch& files);

} // namespace abbe
