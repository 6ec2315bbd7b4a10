#include "io/selftest/white_rows.h"

#include "spectral/data_table.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace abbe {

SelftestRows white_rows() {
  const DataTable whites(embedded_table("expected/whites.csv"));
  SelftestRows rows;
  for (int row = 0; row < whites.row_count(); ++row) {
    const std::string name(whites.field(row, "name"));
    const Chromaticity published{parse_number(whites.field(row, "x_pub")),
                                 parse_number(whites.field(row, "y_pub"))};
    const auto light = find_illuminant(name);
    const Chromaticity c = light ? chromaticity(to_xyz(*light))
                                 : Chromaticity{std::numeric_limits<double>::quiet_NaN(), 0.0};
    // Published with four digits, or five: half of the fourth.
    rows.push_back({"white", fmt::format("{}, x", name), "CIE 15", published.x, c.x, 5.1e-5});
    rows.push_back({"white", fmt::format("{}, y", name), "CIE 15", published.y, c.y, 5.1e-5});
  }
  return rows;
}

} // namespace abbe
