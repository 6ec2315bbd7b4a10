#pragma once

namespace abbe {

/// The size of a camera's image in pixels, and the length of the scene's unit.
struct ImageScale {
  int width = 0, height = 0;
  double mm_per_unit = 1.0;
};

} // namespace abbe
