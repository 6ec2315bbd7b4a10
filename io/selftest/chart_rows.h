#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// The 24 patches of the ColorChecker in a picture of them, under D65 and A.
[[nodiscard]] SelftestRows chart_rows();

} // namespace abbe
