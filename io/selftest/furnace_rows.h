#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// Solids that absorb nothing, in light that is the same from all sides: they cannot be seen.
[[nodiscard]] SelftestRows furnace_rows();

} // namespace abbe
