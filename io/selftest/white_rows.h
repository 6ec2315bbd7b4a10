#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// The white points of the CIE's illuminants.
[[nodiscard]] SelftestRows white_rows();

} // namespace abbe
