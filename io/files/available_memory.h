#pragma once

#include <cstdint>
#include <string>

namespace abbe {

/// How many bytes of memory this process may still take, as far as the system tells: what the
/// machine has free or could free, less where the process's group (cgroup) or the process itself
/// has a limit. The largest number where nothing tells.
[[nodiscard]] std::uint64_t available_memory();

/// How many bytes of addresses this process has in use.
[[nodiscard]] std::uint64_t address_space();

/// How many bytes of memory this process takes now; 0 where nothing tells.
[[nodiscard]] std::uint64_t memory_in_use();

/// Such as "3.5 GiB" or "20 MiB".
[[nodiscard]] std::string memory_text(std::uint64_t bytes);

} // namespace abbe
