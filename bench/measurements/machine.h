#pragma once

#include <string>

namespace abbe::bench {

/// What was measured on, and what with.
struct Machine {
  std::string processor;
  int threads = 0; ///< that the machine runs at once
  double load = 0; ///< processes that wanted to run, mean of the last minute
  std::string abbe, embree, compiler, build_type, architecture;
};

[[nodiscard]] Machine this_machine();

} // namespace abbe::bench
