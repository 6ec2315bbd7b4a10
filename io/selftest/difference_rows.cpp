#include "io/selftest/difference_rows.h"

#include "spectral/color_difference.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

namespace abbe {

SelftestRows difference_rows() {
  const DataTable pairs(embedded_table("expected/delta_e_2000.csv"));
  SelftestRows rows;
  for (int row = 0; row < pairs.row_count(); ++row) {
    const auto value = [&](const char* column) { return parse_number(pairs.field(row, column)); };
    const Lab first{value("L1"), value("a1"), value("b1")};
    const Lab second{value("L2"), value("a2"), value("b2")};
    rows.push_back({"difference", fmt::format("dE2000 of pair {}", row + 1),
                    "Sharma, Wu, Dalal 2005", value("difference"), delta_e_2000(first, second),
                    5.1e-5});
  }
  return rows;
}

} // namespace abbe
