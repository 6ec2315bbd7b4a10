#pragma once

#include "core/plan/plan.h"

namespace abbe {

/// The scene under light of equal energy: every spectrum of a source that is not dark is the
/// constant 1.
[[nodiscard]] Scene equal_energy_scene(Scene scene);

/// A plan for a rendering whose lamps can be changed afterwards. All that it decides (which bands
/// are followed, by how many rays, which lights are sampled how often) it decides for
/// `equal_energy`, which is the scene under such light and is what is to be rendered; only the
/// spectra of the sources are the scene's own. Each pixel gets the same number of samples. Throws
/// UserError for settings that let the picture decide on samples.
[[nodiscard]] Plan plan_relightable(const Scene& scene, const Scene& equal_energy,
                                    RenderSettings settings);

} // namespace abbe
