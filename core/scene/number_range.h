#pragma once

#include <limits>
#include <string_view>

namespace abbe {

/// The numbers that a setting or an argument may have, with words for error messages.
struct Range {
  std::string_view meaning; ///< completes "it is ..."
  double lowest = 0.0;
  double highest = std::numeric_limits<double>::infinity();
  bool open = false; ///< the ends themselves are not allowed

  /// A NaN is in no range.
  [[nodiscard]] constexpr bool holds(double value) const {
    return open ? value > lowest && value < highest : value >= lowest && value <= highest;
  }
};

} // namespace abbe
