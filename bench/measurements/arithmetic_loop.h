#pragma once

#include <cstdint>

namespace abbe::bench {

/// Multiplies and adds in registers, `steps` times in all, shared among so many threads. It keeps
/// the arithmetic units of a core busy and touches no memory, so that its speed on several threads
/// tells what the machine gives them: clocks that fall, threads that share a core, other programs.
/// Returns a number that depends on all of the work.
double arithmetic_loop(std::uint64_t steps, int threads);

} // namespace abbe::bench
