#pragma once

#include "bench/plots/plot.h"
#include "bench/reports/table.h"
#include "bench/reports/write_json.h"

namespace abbe::bench {

/// A plot and a name for its file, of letters, digits and underscores.
struct NamedPlot {
  std::string name;
  std::string svg;
};

/// What belongs together on a page.
struct Section {
  std::vector<Table> tables;
  std::vector<NamedPlot> plots;
};

/// A report for people: each thing that was measured in tables and plots.
[[nodiscard]] std::vector<Section> sections_of(const Report& report);

} // namespace abbe::bench
