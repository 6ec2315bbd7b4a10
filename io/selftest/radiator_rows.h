#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// Black bodies by Planck's law.
[[nodiscard]] SelftestRows radiator_rows();

} // namespace abbe
