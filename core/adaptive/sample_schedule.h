#pragma once

#include "core/scene/settings.h"

namespace abbe {

/// Samples [first, last) of each pixel, in the mean where pixels differ.
struct SampleRange {
  int first = 0, last = 0;
};

/// When a rendering does what, in samples a pixel, in the mean where pixels differ. Samples are
/// rendered in passes, so that a stopped picture is noisy but whole. With adaptive sampling some
/// passes make a round: what its pixels get is decided at its beginning.
class SampleSchedule {
public:
  /// As a plan has them.
  explicit SampleSchedule(const RenderSettings& settings);

  /// Where the round that begins after `done` samples ends. With adaptive sampling the first round
  /// gives all pixels the same, and the second gives the rest; only with a time limit there are
  /// more of these, so that a picture may be whole at any time. Without there is one round.
  [[nodiscard]] int end_of_round(int done) const;
  /// Where the pass that begins after `done` samples ends, in a round that ends at `round_end`.
  [[nodiscard]] int end_of_pass(int done, int round_end) const;
  /// In how many passes a round goes from `done` to `round_end`.
  [[nodiscard]] static int passes(int done, int round_end);
  /// For how many samples light paths are followed before a pass that begins after `done` samples
  /// and ends at `pass_end`.
  [[nodiscard]] int end_of_light_pass(int done, int pass_end) const;
  /// For how many of these samples there is time to follow light paths, which are not given up once
  /// they are begun: for one at least. The samples before the range took `seconds` for their light
  /// paths, and so many are left.
  [[nodiscard]] static int end_in_time(SampleRange samples, double seconds, double seconds_left);
  /// True where tiles may be done: at 64, 96, 128, 192 ... samples. With an earlier first look or
  /// more looks more tiles would end by luck; docs/decisions/noise.md has figures.
  [[nodiscard]] bool may_end(int samples) const;

private:
  /// Time that is running out must leave a whole picture, so the first passes are then short.
  [[nodiscard]] bool in_hurry(int done) const;

  /// The end of the first round of adaptive sampling.
  [[nodiscard]] int first_round() const;

  int most_;
  bool adaptive_, timed_;
};

} // namespace abbe
