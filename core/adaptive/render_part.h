#pragma once

#include "core/adaptive/sample_schedule.h"

#include <cstdint>

namespace abbe {

/// One of several parts into which the samples of a rendering are divided, each of which is
/// rendered on its own. All together they are the whole: docs/farm.md.
struct RenderPart {
  int number = 0; ///< from 0
  int count = 1;  ///< at most as many as there are samples a pixel

  [[nodiscard]] bool is_whole() const { return count == 1; }
  friend bool operator==(const RenderPart&, const RenderPart&) = default;
};

/// The part's samples of a pixel that gets `samples` in all.
[[nodiscard]] constexpr SampleRange samples_of(const RenderPart& part, int samples) {
  const auto border = [&](std::int64_t number) {
    return static_cast<int>(number * samples / part.count);
  };
  return {border(part.number), border(part.number + 1)};
}

/// The number of the part, of `count`, to which a sample belongs.
[[nodiscard]] constexpr int part_of_sample(int sample, int count, int samples) {
  return static_cast<int>(((sample + std::int64_t{1}) * count - 1) / samples);
}

} // namespace abbe
