#pragma once

#include "bench/bands.h"
#include "bench/error.h"
#include "bench/machine.h"
#include "bench/rays.h"

namespace abbe::bench {

// The results as tables for a terminal.
[[nodiscard]] std::string table(const Machine& machine);
[[nodiscard]] std::string table(const RaySpeed& speed);
[[nodiscard]] std::string table(const BandCosts& costs);
[[nodiscard]] std::string table(const ErrorCurves& curves);

} // namespace abbe::bench
