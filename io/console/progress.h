#pragma once

#include "core/render/render.h"

#include <string>

namespace abbe {

/// Tells on standard error how a rendering goes: on a terminal one line that is overwritten, in a
/// log a plain line every tenth of the way. Silent when quiet.
class Progress {
public:
  explicit Progress(bool quiet);
  void tell(const RenderProgress& progress);
  /// Ends the overwritten line.
  void finish();

private:
  bool quiet_;
  bool terminal_;
  int told_tenths_ = 0;
  bool line_open_ = false;
};

/// The closing summary: samples and error where they are estimated, rays by kind, light paths,
/// speed, what the depth limit took, refused samples, peak memory.
[[nodiscard]] std::string summary(const Rendering& rendering);

/// A warning where the picture lacks light that a limit has taken; else empty.
[[nodiscard]] std::string light_warning(const Rendering& rendering);

} // namespace abbe
