#include "core/render/peers.h"

namespace abbe {

bool Peers::all(bool value) const {
  if (alone()) return value;
  std::int64_t yes = value ? 1 : 0;
  add_up(Numbers(&yes, 1));
  return yes == count;
}

bool Peers::has_tile(std::size_t tile) const {
  // Multiples of the golden ratio, modulo 1 in parts of 2^32, lie evenly in any run of them.
  const std::uint64_t place = (std::uint64_t{tile} * 0x9e3779b9) & 0xffffffff;
  return (place * static_cast<std::uint64_t>(count)) >> 32 == static_cast<std::uint64_t>(number);
}

} // namespace abbe
