#include "io/files/available_memory.h"

#include <fmt/format.h>

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>

namespace abbe {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// The number that a file begins with; nothing where there is none, as in "max".
std::optional<std::uint64_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  if (file >> number) return number;
  return std::nullopt;
}

/// What the machine has free, with what it could free of its caches and swap.
std::uint64_t free_on_machine() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  std::uint64_t kibibytes = 0, sum = 0;
  bool found = false;
  while (file >> name >> kibibytes && std::getline(file, unit))
    if (name == "MemAvailable:" || name == "SwapFree:") {
      sum += kibibytes * 1024;
      found = true;
    }
  return found ? sum : kUnlimited;
}

/// What is left below a limit, given what is used of it.
std::uint64_t left(const std::string& limit, const std::string& used) {
  const auto most = number_in(limit), now = number_in(used);
  if (!most || !now) return kUnlimited;
  return *most > *now ? *most - *now : 0;
}

/// What the control groups leave, as they look from inside a container.
std::uint64_t free_in_group() {
  const std::string root = "/sys/fs/cgroup/";
  return std::min(
      left(root + "memory.max", root + "memory.current"),
      left(root + "memory/memory.limit_in_bytes", root + "memory/memory.usage_in_bytes"));
}

/// What `ulimit -v` leaves.
std::uint64_t free_address_space() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
  const std::uint64_t used = address_space();
  return limit.rlim_cur > used ? limit.rlim_cur - used : 0;
}

} // namespace

std::uint64_t available_memory() {
  return std::min({free_on_machine(), free_in_group(), free_address_space()});
}

std::uint64_t address_space() {
  return number_in("/proc/self/statm").value_or(0) * 4096;
}

std::uint64_t memory_in_use() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  return file >> all >> resident ? resident * 4096 : 0;
}

std::string memory_text(std::uint64_t bytes) {
  constexpr double kMiB = 1 << 20, kGiB = 1 << 30;
  const auto size = static_cast<double>(bytes);
  return size < kGiB ? fmt::format("{:.0f} MiB", std::max(1.0, size / kMiB))
                     : fmt::format("{:.1f} GiB", size / kGiB);
}

} // namespace abbe
