#include "spectral/color_space.h"

#include "spectral/data_table.h"

namespace abbe {
namespace {

std::vector<ColorSpace> load_spaces() {
  const DataTable table{embedded_table("colourspaces.csv")};
  std::vector<ColorSpace> list;
  for (int row = 0; row < table.row_count(); ++row) {
    const auto point = [&](std::string_view x, std::string_view y) {
      return Chromaticity{parse_number(table.field(row, x)), parse_number(table.field(row, y))};
    };
    list.push_back({std::string(table.field(row, "name")),
                    {point("xr", "yr"), point("xg", "yg"), point("xb", "yb")},
                    point("xw", "yw"),
                    std::string(table.field(row, "standard"))});
  }
  return list;
}

} // namespace

const std::vector<ColorSpace>& color_spaces() {
  static const std::vector<ColorSpace> list = load_spaces();
  return list;
}

std::optional<ColorSpace> find_color_space(std::string_view name) {
  for (const ColorSpace& space : color_spaces())
    if (same_name(space.name, name)) return space;
  return std::nullopt;
}

} // namespace abbe
