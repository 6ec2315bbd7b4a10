#pragma once

#include "io/selftest/selftest_row.h"

#include <string>

namespace abbe {

/// Checks this build against optics and colour science: all rows, those of one subject together. A
/// subject that cannot be computed at all gives one row that does not pass and says why.
[[nodiscard]] SelftestRows run_selftest();

/// How many rows do not pass.
[[nodiscard]] std::size_t failures(const SelftestRows& rows);

/// The rows as a table for people, one line each, with the failures counted at the end.
[[nodiscard]] std::string selftest_table(const SelftestRows& rows);

/// The same for programs: {"rows": [...], "passed": n, "failed": n}. A number that is not finite is
/// null.
[[nodiscard]] std::string selftest_json(const SelftestRows& rows);

} // namespace abbe
