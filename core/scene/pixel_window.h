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
  friend bool operator==(const PixelWindow&, const PixelWindow&) = default;
};

} // namespace abbe
