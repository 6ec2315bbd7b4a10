#pragma once

#include <cstdint>

namespace abbe {

/// What the first surface that a camera path meets has done with it. Panes are looked through.
enum class View : std::uint8_t {
  direct,     ///< the surface itself is seen, or no surface at all
  reflection, ///< it has mirrored the path
  refraction, ///< it has refracted the path
};
inline constexpr int kViews = 3;

/// How light has come to what the camera sees, be it seen by mirrors and glass or not.
enum class Arrival : std::uint8_t {
  direct,   ///< straight from the light, or the light itself is seen
  indirect, ///< by way of at least one other surface that scatters other than specularly
  caustic,  ///< from the light by mirrors and glass alone
};
inline constexpr int kArrivals = 3;

} // namespace abbe
