#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// What thin films on glass reflect, in pictures of them.
[[nodiscard]] SelftestRows film_rows();

} // namespace abbe
