#include "bench/measurements/memory.h"

#include <malloc.h>
#include <unistd.h>

#include <fstream>

namespace abbe::bench {

std::size_t resident_bytes() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::optional<std::size_t> added_bytes(std::size_t before) {
  // Stacks and the caches of libraries move by less than this.
  constexpr std::size_t kLeast = std::size_t{1} << 18;
  const std::size_t now = resident_bytes();
  if (now < before + kLeast) return std::nullopt;
  return now - before;
}

} // namespace abbe::bench
