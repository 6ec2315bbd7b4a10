#pragma once

#include "core/adaptive/sample_schedule.h"
#include "core/bundles/statistics.h"
#include "core/film/film.h"
#include "core/integrators/light_pass.h"
#include "core/plan/plan.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace abbe {

/// Where a tile was left within a pass: so many pixels, row by row, have had all their samples of
/// the pass, and the next one has had so many.
struct LeftPass {
  std::uint32_t pixels = 0, samples = 0;
};

/// How far a tile of the plan has come.
struct TileState {
  int samples = 0;    ///< its pixels have had all samples before this one, in the mean
  bool ended = false; ///< it needs no more
  LeftPass left = {}; ///< of the next pass
};

/// All that a rendering has come to: plain values, from which it goes on as if it had never been
/// interrupted. What else rendering needs follows from the scene and its plan.
struct RenderState {
  Film film;
  int done = 0;                 ///< all tiles that go on have had so many samples a pixel, or more
  std::vector<TileState> tiles; ///< by number of the plan's tile
  RayCounts rays = {};
  double seconds = 0.0;
  double light_seconds = 0.0; ///< of these, in light-side passes
  LightPassState light = {};

  // Adaptive sampling.
  bool planned = false;           ///< the shares were known before: no sample decides on others
  int round_end = 0;              ///< where the current round ends
  std::vector<float> shares = {}; ///< by the first round; empty before its end
  std::vector<std::uint32_t> allocation = {}; ///< what each pixel shall have then; empty: the same
  std::vector<std::uint32_t> pixel_rays = {}; ///< how many rays each pixel has taken so far
};

/// Gives a rendering that has not begun the shares by which its samples are spread, of `samples` a
/// pixel in the mean. Then no sample decides on others, and it can be rendered in parts.
void spread_samples(RenderState& state, std::vector<float> shares, int samples);

/// A copy whose film keeps the sums of bands where `place` says. Errors: those of FileBackedSums.
[[nodiscard]] RenderState copy_of(const RenderState& state, const BandPlace& place);

/// A rendering that has not begun. Its film keeps the sums of all bands where `bands` says where
/// to, and errors where the settings need them. Of a part, `render` takes the samples of that part
/// alone (`samples_of`). Errors: those of FileBackedSums.
[[nodiscard]] RenderState begin_rendering(const Scene& scene, const Plan& plan,
                                          const std::optional<BandPlace>& bands = {},
                                          const RenderPart& part = {});

} // namespace abbe
