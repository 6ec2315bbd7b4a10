// The scenes of the furnace, rendered by several numbers of threads, without skips, and by single
// rays: no bit may differ. One at a time, since oneTBB's number of threads is that of a process.
#include "tests/stress/furnace/trials.h"
#include "tests/stress/part.h"

namespace abbe::stress {
namespace {

void round(std::uint64_t number, Tally& tally) {
  try_scene(number, Asked::bytes, tally);
}

} // namespace

const Part kPart{"bytes", 100, 10000, Rounds::one_at_a_time, round};

} // namespace abbe::stress
