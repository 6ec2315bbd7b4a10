#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// What glass and metals reflect, in pictures of them.
[[nodiscard]] SelftestRows fresnel_rows();

} // namespace abbe
