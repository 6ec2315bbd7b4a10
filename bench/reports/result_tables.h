#pragma once

#include "bench/measurements/bands.h"
#include "bench/measurements/error.h"
#include "bench/measurements/machine.h"
#include "bench/measurements/plan_skips.h"
#include "bench/measurements/rays.h"
#include "bench/measurements/scaling.h"
#include "bench/reports/table.h"

namespace abbe::bench {

/// What was measured on, and how the figures are to be read.
[[nodiscard]] Table table_of(const Machine& machine);

// What was measured, in rows.
[[nodiscard]] Table table_of(const RaySpeed& speed);
/// One row for each.
[[nodiscard]] Table overview(const std::vector<RaySpeed>& speeds);
[[nodiscard]] Table table_of(const BandCosts& costs);
[[nodiscard]] Table budgets_table(const ErrorCurves& curves);
[[nodiscard]] Table table_of(const SkipCosts& costs);
[[nodiscard]] Table times_table(const ErrorCurves& curves);
/// A table for each axis that was measured.
[[nodiscard]] std::vector<Table> tables_of(const Scaling& scaling);

} // namespace abbe::bench
