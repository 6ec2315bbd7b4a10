#pragma once

#include <cstdint>

namespace abbe {

/// How many rays were traced, by kind.
struct RayCounts {
  std::uint64_t camera = 0, reflected = 0, refracted = 0, shadow = 0;

  [[nodiscard]] std::uint64_t total() const { return camera + reflected + refracted + shadow; }
  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    reflected += other.reflected;
    refracted += other.refracted;
    shadow += other.shadow;
    return *this;
  }
};

} // namespace abbe
