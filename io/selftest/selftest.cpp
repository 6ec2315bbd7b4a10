#include "io/selftest/selftest.h"

#include "io/selftest/absorption_rows.h"
#include "io/selftest/angle_rows.h"
#include "io/selftest/chart_rows.h"
#include "io/selftest/difference_rows.h"
#include "io/selftest/film_rows.h"
#include "io/selftest/fresnel_rows.h"
#include "io/selftest/furnace_rows.h"
#include "io/selftest/lens_rows.h"
#include "io/selftest/newton_rows.h"
#include "io/selftest/prism_rows.h"
#include "io/selftest/radiator_rows.h"
#include "io/selftest/rainbow_rows.h"
#include "io/selftest/white_rows.h"
#include "io/text/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>

namespace abbe {
namespace {

struct Subject {
  const char* name;
  SelftestRows (*rows)();
};

constexpr Subject kSubjects[] = {{"prism", prism_rows},
                                 {"angles", angle_rows},
                                 {"Fresnel", fresnel_rows},
                                 {"film", film_rows},
                                 {"lens", lens_rows},
                                 {"rainbow", rainbow_rows},
                                 {"absorption", absorption_rows},
                                 {"furnace", furnace_rows},
                                 {"Newton", newton_rows},
                                 {"white", white_rows},
                                 {"radiator", radiator_rows},
                                 {"chart", chart_rows},
                                 {"difference", difference_rows}};

SelftestRows rows_of(const Subject& subject) {
  try {
    return subject.rows();
  } catch (const std::exception& error) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {{subject.name, error.what(), "-", 0.0, kUnknown, 0.0}};
  }
}

} // namespace

SelftestRows run_selftest() {
  SelftestRows all;
  for (const Subject& subject : kSubjects)
    for (SelftestRow& row : rows_of(subject))
      all.push_back(std::move(row));
  return all;
}

std::size_t failures(const SelftestRows& rows) {
  return static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const SelftestRow& row) { return !row.passed(); }));
}

std::string selftest_table(const SelftestRows& rows) {
  std::string table =
      fmt::format("{:<6} {:<11} {:<44} {:<30} {:>13} {:>13} {:>9} {}\n", "", "subject", "what",
                  "expected by", "expected", "got", "tolerance", "unit");
  for (const SelftestRow& row : rows)
    table += fmt::format("{:<6} {:<11} {:<44} {:<30} {:>13.7f} {:>13.7f} {:>9.1e} {}\n",
                         row.passed() ? "ok" : "FAILED", row.subject, row.what, row.source,
                         row.expected, row.got, row.tolerance, row.unit);
  const std::size_t failed = failures(rows);
  return table + (failed == 0
                      ? fmt::format("all {} values are as expected", rows.size())
                      : fmt::format("{} of {} values are not as expected", failed, rows.size()));
}

std::string selftest_json(const SelftestRows& rows) {
  std::string json = "{\"rows\": [";
  const char* separator = "\n";
  for (const SelftestRow& row : rows) {
    json += fmt::format("{}  {{\"subject\": {}, \"what\": {}, \"source\": {}, \"unit\": {}, "
                        "\"expected\": {}, \"got\": {}, \"tolerance\": {}, \"passed\": {}}}",
                        separator, json_string(row.subject), json_string(row.what),
                        json_string(row.source), json_string(row.unit), json_number(row.expected),
                        json_number(row.got), json_number(row.tolerance), row.passed());
    separator = ",\n";
  }
  const std::size_t failed = failures(rows);
  return json + fmt::format("\n], \"passed\": {}, \"failed\": {}}}", rows.size() - failed, failed);
}

} // namespace abbe
