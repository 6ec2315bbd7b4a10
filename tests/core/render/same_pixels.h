#pragma once

#include "core/film/film.h"

namespace abbe::test {

/// True when two films of one window hold the same colours and numbers of samples.
inline bool same_pixels(const Film& a, const Film& b) {
  const PixelWindow w = a.window();
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.x0; x < w.x1; ++x)
      if (!(a.color(x, y) == b.color(x, y)) || a.samples(x, y) != b.samples(x, y)) return false;
  return true;
}

} // namespace abbe::test
