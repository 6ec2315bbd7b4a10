#include "io/selftest/expected_index.h"

#include "spectral/data_table.h"
#include "spectral/glass.h"

#include <stdexcept>
#include <string>

namespace abbe {

std::array<double, 3> expected_index(std::string_view glass) {
  const DataTable table(embedded_table("expected/glass_lines.csv"));
  for (int row = 0; row < table.row_count(); ++row)
    if (table.field(row, "name") == glass)
      return {parse_number(table.field(row, "F")), parse_number(table.field(row, "d")),
              parse_number(table.field(row, "C"))};
  throw std::out_of_range("no expected index of " + std::string(glass));
}

double catalogue_index(std::string_view glass, double lambda_nm) {
  const Glass* found = find_glass(glass);
  if (!found) throw std::out_of_range("no glass " + std::string(glass));
  return refractive_index(found->dispersion, lambda_nm);
}

} // namespace abbe
