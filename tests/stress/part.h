#pragma once

#include "tests/stress/tally.h"

#include <cstdint>

namespace abbe::stress {

/// How the rounds of a part share the machine.
enum class Rounds : std::uint8_t {
  on_all_cores,  ///< one on each core at a time: a round runs on one thread
  one_at_a_time, ///< a round uses all cores itself
};

/// A part of the stress suite: rounds that differ by their number alone, which is their seed. Each
/// program of the suite defines one.
struct Part {
  const char* name;
  std::uint64_t short_rounds, long_rounds;
  Rounds rounds;
  void (*round)(std::uint64_t number, Tally& tally);
};

/// Defined by each program, once.
extern const Part kPart;

} // namespace abbe::stress
