#include "tests/stress/part.h"

namespace abbe::stress {

namespace {
void round(std::uint64_t, Tally& tally) {
  tally.count("rays");
}
} // namespace

const Part kPart{"rays", 64, 64000, Rounds::on_all_cores, round};

} // namespace abbe::stress
