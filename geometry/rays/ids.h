#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace abbe {

/// An index that converts to no other index. Negative: nothing.
template <class Tag>
struct Id {
  std::int32_t value = -1;

  [[nodiscard]] constexpr bool valid() const { return value >= 0; }
  [[nodiscard]] constexpr std::size_t index() const { return static_cast<std::size_t>(value); }
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using ShapeId = Id<struct ShapeTag>;       ///< index into the scene's shapes
using MaterialId = Id<struct MaterialTag>; ///< a label that geometry only passes on
using MediumId = Id<struct MediumTag>;     ///< a label that geometry only passes on

} // namespace abbe
