#pragma once

#include <string>
#include <vector>

namespace abbe::bench {

/// Results in rows, as they are read by people; write_html.h has the other way to show them.
struct Table {
  std::string title;
  std::vector<std::string> columns;           ///< headings; no table but notes when empty
  std::vector<std::vector<std::string>> rows; ///< as many cells as there are columns
  std::vector<std::string> notes;             ///< sentences below
};

/// The table for a terminal: the first column to the left, the others to the right.
[[nodiscard]] std::string to_text(const Table& table);

} // namespace abbe::bench
