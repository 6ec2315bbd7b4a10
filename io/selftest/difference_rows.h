#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// CIEDE2000 of its published test pairs.
[[nodiscard]] SelftestRows difference_rows();

} // namespace abbe
