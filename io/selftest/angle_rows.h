#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// The critical angle and Brewster's angle of some glasses.
[[nodiscard]] SelftestRows angle_rows();

} // namespace abbe
