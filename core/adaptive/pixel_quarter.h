#pragma once

#include "core/scene/pixel_window.h"

#include <cstddef>

namespace abbe {

/// The pixels of a picture fall into four quarters, each of every second pixel of every second row.
/// All neighbours of a pixel are of other quarters. docs/decisions/noise.md tells what for.
inline constexpr std::size_t kQuarters = 4;

/// The number of the pixel's quarter; coordinates are those of the whole picture.
[[nodiscard]] inline std::size_t quarter_of(int x, int y) {
  return static_cast<std::size_t>((x & 1) + 2 * (y & 1));
}

/// Calls `use(x)` for the quarter's pixels in the row y of the window, from left to right.
template <class Use>
void for_each_in_row(const PixelWindow& window, std::size_t quarter, int y, const Use& use) {
  if (quarter_of(0, y) != (quarter & 2)) return;
  const int column = static_cast<int>(quarter & 1);
  for (int x = window.x0 + ((window.x0 ^ column) & 1); x < window.x1; x += 2)
    use(x);
}

} // namespace abbe
