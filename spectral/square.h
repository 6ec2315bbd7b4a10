#pragma once

namespace abbe {

[[nodiscard]] constexpr double square(double x) {
  return x * x;
}

} // namespace abbe
