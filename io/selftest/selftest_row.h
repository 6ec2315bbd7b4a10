#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace abbe {

/// One truth that `abbe selftest` checks: a value that this build computes, beside the one that a
/// closed form or a published table gives. The expected value never comes from the code that is
/// checked.
struct SelftestRow {
  std::string subject; ///< such as "prism"; rows of one subject stand together
  std::string what;    ///< which value, where and of what
  std::string source;  ///< the formula or the table of the expected value
  double expected = 0.0;
  double got = 0.0;
  double tolerance = 0.0; ///< the largest difference that passes
  std::string unit = {};  ///< of the three numbers; empty for those that have none

  /// A value that is no number does not pass.
  [[nodiscard]] bool passed() const { return std::abs(got - expected) <= tolerance; }
};

using SelftestRows = std::vector<SelftestRow>;

} // namespace abbe
