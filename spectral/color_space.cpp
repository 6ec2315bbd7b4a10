#include "spectral/color_space.h"

#include "spectral/data_table.h"

#include <algorithm>

namespace abbe {
namespace {

std::vector<ColorSpace> load_spaces() {
  const DataTable table{embedded_table("colourspaces.csv")};
  std::vector<ColorSpace> list;
  for (int row = 0; row < table.row_count(); ++row) {
    const auto point = [&](std::string_view x, std::string_view y) {
      return Chromaticity{parse_number(table.field(row, x)), parse_number(table.field(row, y))};
    };
    const auto names = split_words(table.field(row, "short"));
    list.push_back({std::string(table.field(row, "name")),
                    {point("xr", "yr"), point("xg", "yg"), point("xb", "yb")},
                    point("xw", "yw"),
                    std::string(table.field(row, "standard")),
                    {names.begin(), names.end()},
                    find_transfer(table.field(row, "curve")).value()});
  }
  return list;
}

} // namespace

const std::vector<ColorSpace>& color_spaces() {
  static const std::vector<ColorSpace> list = load_spaces();
  return list;
}

std::optional<ColorSpace> find_color_space(std::string_view name) {
  const auto is_wanted = [&](const std::string& known) { return same_name(known, name); };
  for (const ColorSpace& space : color_spaces())
    if (is_wanted(space.name) || std::ranges::any_of(space.short_names, is_wanted)) return space;
  return std::nullopt;
}

std::vector<std::string> color_space_names() {
  std::vector<std::string> names;
  for (const ColorSpace& space : color_spaces())
    names.insert(names.end(), space.short_names.begin(), space.short_names.end());
  return names;
}

const ColorSpace& srgb_space() {
  static const ColorSpace space = find_color_space("srgb").value();
  return space;
}

} // namespace abbe
