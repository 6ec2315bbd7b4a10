// Random scenes in light of radiance 1 from everywhere, and lossy ones against an independent
// account of where light goes; see docs/stability.md.
#include "tests/stress/furnace/trials.h"
#include "tests/stress/part.h"

namespace abbe::stress {
namespace {

void round(std::uint64_t number, Tally& tally) {
  try_scene(number, Asked::furnace, tally);
  try_scene(number, Asked::energy, tally);
}

} // namespace

const Part kPart{"furnace", 100, 10000, Rounds::on_all_cores, round};

} // namespace abbe::stress
