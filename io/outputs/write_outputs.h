#pragma once

#include "core/render/render.h"
#include "core/scene/display_settings.h"
#include "io/images/write_image.h"
#include "io/outputs/check_outputs.h"
#include "io/outputs/denoised_pictures.h"

namespace abbe {

/// A rendering of which pictures are made.
struct Rendered {
  const Rendering& rendering;
  const Plan& plan;
  const DenoisedPictures* denoised = nullptr; ///< null: its pictures keep their noise
};

/// Writes all images of a rendering, also where some cannot be written, and warns where a picture
/// for screens shows nothing of a film that is not black. Each kind of picture is in memory only
/// while its files are written. Returns false when some file could not be written.
[[nodiscard]] bool write_outputs(const Rendered& rendered, const Outputs& outputs,
                                 const OutputOptions& options,
                                 const DisplaySettings& display_settings, bool quiet);

} // namespace abbe
