#include "bench/reports/compare.h"

#include "bench/measurements/timing.h"
#include "core/scene/user_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe::bench {
namespace {

constexpr double kConfidence = 0.95;

/// What takes less is not judged: its first run of a program, or a page that is not there yet,
/// makes more of a difference than code does.
constexpr double kLeastSeconds = 1e-3;

const char* word(Verdict verdict) {
  switch (verdict) {
  case Verdict::faster:
    return "faster";
  case Verdict::slower:
    return "slower";
  case Verdict::noise:
    return "noise";
  case Verdict::too_few:
    return "too few repeats";
  }
  return "";
}

Change change_of(const Timing& first, const Timing& second, double margin) {
  Change change;
  change.name = first.name;
  const double before = summary(first.repeats).median, after = summary(second.repeats).median;
  change.ratio = after / before;
  change.interval = ratio_interval(first.repeats, second.repeats, kConfidence);
  if (std::max(before, after) < kLeastSeconds) return change;
  if (!change.interval)
    change.verdict = Verdict::too_few;
  else if (change.interval->lowest > 1.0 + margin)
    change.verdict = Verdict::slower;
  else if (change.interval->highest < 1.0 / (1.0 + margin))
    change.verdict = Verdict::faster;
  return change;
}

} // namespace

bool Comparison::slower() const {
  return std::any_of(changes.begin(), changes.end(),
                     [](const Change& c) { return c.verdict == Verdict::slower; });
}

Comparison compare(const std::string& first_json, const std::string& second_json, double margin) {
  const std::vector<Timing> first = timings_of(first_json);
  std::vector<Timing> second = timings_of(second_json);
  Comparison result;
  result.machine = machine_differences(first_json, second_json);
  for (const Timing& timing : first) {
    const auto like = std::find_if(second.begin(), second.end(),
                                   [&](const Timing& t) { return t.name == timing.name; });
    if (like == second.end()) {
      result.only_first.push_back(timing.name);
      continue;
    }
    result.changes.push_back(change_of(timing, *like, margin));
    second.erase(like);
  }
  for (const Timing& timing : second)
    result.only_second.push_back(timing.name);
  if (result.changes.empty()) throw UserError("the two reports have no timing in common");
  return result;
}

Table table_of(const Comparison& comparison) {
  Table table{"second over first", {"timing", "ratio", "from", "to", ""}, {}, {}};
  std::size_t faster = 0, slower = 0;
  for (const Change& c : comparison.changes) {
    const auto bound = [&c](double RatioInterval::* end) {
      return c.interval ? fmt::format("{:.3f}", *c.interval.*end) : "-";
    };
    table.rows.push_back({c.name, fmt::format("{:.3f}", c.ratio), bound(&RatioInterval::lowest),
                          bound(&RatioInterval::highest), word(c.verdict)});
    faster += c.verdict == Verdict::faster ? 1 : 0;
    slower += c.verdict == Verdict::slower ? 1 : 0;
  }
  table.notes.push_back(fmt::format("{} slower, {} faster, {} neither", slower, faster,
                                    comparison.changes.size() - slower - faster));
  for (const std::string& name : comparison.only_first)
    table.notes.push_back("only in the first: " + name);
  for (const std::string& name : comparison.only_second)
    table.notes.push_back("only in the second: " + name);
  for (const std::string& difference : comparison.machine)
    table.notes.push_back("differs: " + difference);
  return table;
}

} // namespace abbe::bench
