#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// How light falls off in media that absorb it.
[[nodiscard]] SelftestRows absorption_rows();

} // namespace abbe
