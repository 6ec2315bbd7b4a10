#pragma once

#include "io/selftest/selftest_row.h"

namespace abbe {

/// The radii of the two bows of drops of water: by rays through a ball of water, and in a picture
/// of rain.
[[nodiscard]] SelftestRows rainbow_rows();

} // namespace abbe
