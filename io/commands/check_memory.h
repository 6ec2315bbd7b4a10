#pragma once

#include "core/film/layer.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace abbe {

/// What takes memory, and what makes it take less.
struct MemoryNeed {
  std::uint64_t bytes = 0;
  std::string_view what, cure;
};

[[nodiscard]] constexpr MemoryNeed picture_needs(std::uint64_t bytes) {
  return {bytes, "the picture", "Make it smaller, or render parts of it with --crop"};
}
[[nodiscard]] constexpr MemoryNeed plan_needs(std::uint64_t bytes) {
  return {bytes, "the plan of the scene's materials and glasses",
          "Give things that look the same one material"};
}

/// Throws UserError where a rendering needs more memory than the limit, which is what is available
/// where the user gives none. It tells both. A limit that the user gives is one on all that the
/// process takes: what it holds already, the scene above all, counts too.
void check_memory(MemoryNeed need, std::optional<double> limit_gib);

/// Tells on standard output how much of a disk the rendering takes meanwhile, if it takes any.
void tell_disk(std::uint64_t bytes, const BandPlace& place);

} // namespace abbe
