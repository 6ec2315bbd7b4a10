#pragma once

namespace abbe {

/// The bands from `first` up to, but without, `last`.
struct BandRange {
  int first = 0, last = 0;

  [[nodiscard]] int size() const { return last - first; }
  [[nodiscard]] bool empty() const { return first == last; }
};

} // namespace abbe
