#pragma once

#include "core/render/render_progress.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace abbe {

/// Processes that render one picture together, each into a state of its own, and what they ask of
/// each other. All of them call the same functions in the same order, each from the thread that
/// renders, but for progress. One that is alone calls none.
struct Peers {
  using Numbers = std::span<std::int64_t>;

  int number = 0; ///< of this one, from 0
  int count = 1;
  /// Puts in the place of each number the sum of what all peers have there.
  std::function<void(Numbers)> add_up = {};
  /// Does the same in the first alone. What the others have then means nothing.
  std::function<void(Numbers)> add_up_in_first = {};
  /// Gives the first the lists of all, one after the other, and the others an empty list.
  std::function<std::vector<std::int64_t>(const std::vector<std::int64_t>&)> collect_in_first = {};

  /// Tells the others now and then how far this one is, and returns how far they are together, as
  /// far as this one knows. Any thread may call it, but no two at once, and not all peers must.
  std::function<RenderProgress(const RenderProgress&)> share_progress = {};

  [[nodiscard]] bool alone() const { return count == 1; }
  [[nodiscard]] bool is_first() const { return number == 0; }
  /// True where all say so.
  [[nodiscard]] bool all(bool value) const;
  /// True where this one renders the tile of this number. Tiles near each other cost about the
  /// same, so each run of them is shared evenly, and no row like the one above it.
  [[nodiscard]] bool has_tile(std::size_t tile) const;
};

} // namespace abbe
