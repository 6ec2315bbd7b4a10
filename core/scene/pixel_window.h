#pragma once

#include <cstddef>

namespace abbe {

/// A half-open rectangle of pixels: x0 <= x < x1, y0 <= y < y1, y downwards from the top row.
struct PixelWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
  [[nodiscard]] std::size_t pixel_count() const {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  }
  /// The number of a pixel of the window, row by row.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x - x0);
  }
  friend bool operator==(const PixelWindow&, const PixelWindow&) = default;
};

/// Calls `use(x, y)` for the pixels of the window, row by row.
template <class Use>
void for_each_pixel(const PixelWindow& window, const Use& use) {
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      use(x, y);
}

} // namespace abbe
