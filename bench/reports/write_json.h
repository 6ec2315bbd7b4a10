#pragma once

#include "bench/measurements/bands.h"
#include "bench/measurements/error.h"
#include "bench/measurements/machine.h"
#include "bench/measurements/plan_skips.h"
#include "bench/measurements/rays.h"
#include "bench/measurements/scaling.h"

namespace abbe::bench {

/// What one run of the bench found; a measurement that was not made is an empty list.
struct Report {
  Machine machine;
  std::vector<RaySpeed> rays;
  std::vector<BandCosts> bands;
  std::vector<ErrorCurves> errors;
  std::vector<SkipCosts> plans;
  std::vector<Scaling> scalings;
};

/// The report as JSON. Its keys are the names of the structs' members.
[[nodiscard]] std::string to_json_text(const Report& report);

} // namespace abbe::bench
