#pragma once

#include <bit>
#include <cstdint>

namespace abbe {

/// The two parts of a pixel's samples whose difference tells the error of their mean.
enum class Stratum : std::uint8_t { first, second };

/// How a pixel's samples are divided. A sample's index alone says where it lies: those below the
/// boundary are in the first stratum, the others in the second.
struct PixelStrata {
  std::uint32_t boundary = 0; ///< a power of two, or 0 where the first stratum is empty
  std::uint32_t first = 0;    ///< how many samples the first stratum has

  [[nodiscard]] Stratum of(std::uint32_t index) const {
    return index < boundary ? Stratum::first : Stratum::second;
  }
  friend bool operator==(const PixelStrata&, const PixelStrata&) = default;
};

/// The boundary for samples the last of which has this index: the largest power of two that leaves
/// it in the second stratum. When a later sample moves the boundary from b to a higher one, all
/// samples so far have indices below 2 b, hence below the new boundary: the first stratum takes all
/// of them. So a film needs no single sample again, and what it holds does not depend on the order
/// in which samples come. docs/decisions/noise.md tells why the strata are such.
[[nodiscard]] constexpr std::uint32_t strata_boundary(std::uint32_t last_index) {
  return std::bit_floor(last_index);
}

} // namespace abbe
