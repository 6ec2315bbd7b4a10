#pragma once

#include "core/image/image.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>

namespace abbe {

/// Errors: `std::runtime_error` for an image without pixels. A buffer of another size than
/// `data` times `channels` is a broken contract.
inline void require_pixels(const PixelWindow& display, const PixelWindow& data,
                           [[maybe_unused]] std::size_t value_count,
                           [[maybe_unused]] std::size_t channels) {
  if (display.width() <= 0 || display.height() <= 0 || data.width() <= 0 || data.height() <= 0)
    throw std::runtime_error("the image has no pixels");
  assert(value_count == data.pixel_count() * channels);
}

/// The nearest of the integers 0 ... max of `Code` for each value in [0, 1], ties upwards, without
/// dithering. Values outside are clamped; NaN gives 0. An image's rows are coded one by one, as
/// they are written.
template <class Code>
void code_values(std::span<const float> values, Code* codes) {
  constexpr double max = std::numeric_limits<Code>::max();
  for (const float value : values) {
    const double unit = value > 0.0f ? std::fmin(value, 1.0) : 0.0;
    *codes++ = static_cast<Code>(std::floor(unit * max + 0.5));
  }
}

} // namespace abbe
