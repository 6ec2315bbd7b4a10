#include "bench/reports/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace abbe::bench {

std::string to_text(const Table& table) {
  std::string text = "\n" + table.title + "\n";
  std::vector<std::size_t> widths;
  for (const std::string& heading : table.columns)
    widths.push_back(heading.size());
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < widths.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  const auto add_row = [&](const std::vector<std::string>& cells) {
    fmt::format_to(std::back_inserter(text), "  {:<{}}", cells[0], widths[0]);
    for (std::size_t i = 1; i < widths.size(); ++i)
      fmt::format_to(std::back_inserter(text), "  {:>{}}", cells[i], widths[i]);
    text += '\n';
  };
  if (!table.columns.empty()) {
    add_row(table.columns);
    for (const auto& row : table.rows)
      add_row(row);
  }
  for (const std::string& note : table.notes)
    text += "  " + note + "\n";
  return text;
}

} // namespace abbe::bench
