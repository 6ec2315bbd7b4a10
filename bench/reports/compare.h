#pragma once

#include "bench/reports/rank_interval.h"
#include "bench/reports/table.h"

#include <cstdint>
#include <string>

namespace abbe::bench {

/// One thing that was timed, as a report's JSON has it.
struct Timing {
  std::string name; ///< what and where, such as "rays, lens, 256x256, 81 bands, 4 spp: render"
  std::vector<double> repeats; ///< seconds of processor time
};

/// All timings of a report. Throws UserError when the text is no report of the bench.
[[nodiscard]] std::vector<Timing> timings_of(const std::string& json_text);

/// What two reports say differently of machine and build, in words; the load does not count.
[[nodiscard]] std::vector<std::string> machine_differences(const std::string& first_json,
                                                           const std::string& second_json);

enum class Verdict : std::uint8_t { faster, slower, noise, too_few };

/// The same thing timed twice.
struct Change {
  std::string name;
  double ratio = 1.0; ///< median of the second over that of the first
  std::optional<RatioInterval> interval;
  Verdict verdict = Verdict::noise;
};

struct Comparison {
  std::vector<Change> changes;
  std::vector<std::string> only_first, only_second; ///< timings without their like
  std::vector<std::string> machine; ///< what differs of machine and build, in sentences

  [[nodiscard]] bool slower() const;
};

/// Compares two reports. A change is one whose whole 95 % interval is farther from 1 than `margin`,
/// the share by which two runs may differ for reasons of their own. Throws UserError
/// when a text is no report, or when they have nothing in common.
[[nodiscard]] Comparison compare(const std::string& first_json, const std::string& second_json,
                                 double margin);

[[nodiscard]] Table table_of(const Comparison& comparison);

} // namespace abbe::bench
