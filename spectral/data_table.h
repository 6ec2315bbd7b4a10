#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace abbe {

/// One file of spectral/data/, compiled in.
struct EmbeddedTable {
  std::string_view file_name; ///< relative to spectral/data/, e.g. "illuminants/D65.csv"
  std::string_view text;
};

/// All compiled-in files, in the order of spectral/CMakeLists.txt.
[[nodiscard]] std::span<const EmbeddedTable> embedded_tables();

/// The text of a compiled-in file. Throws std::out_of_range when there is none of this name.
[[nodiscard]] std::string_view embedded_table(std::string_view file_name);

/// True when two names are equal but for the case of ASCII letters.
[[nodiscard]] bool same_name(std::string_view a, std::string_view b);

/// A number as the tables write it. Throws std::invalid_argument when `text` is not wholly one.
[[nodiscard]] double parse_number(std::string_view text);

/// The words of `text` that lie between single or repeated spaces.
[[nodiscard]] std::vector<std::string_view> split_words(std::string_view text);

/// A parsed comma-separated table. Its fields point into the text it was parsed from.
class DataTable {
public:
  /// Lines that start with # are comments, the next one names the columns; no quoting is known.
  /// Throws std::invalid_argument when there is no header or a row has another number of fields.
  explicit DataTable(std::string_view text);

  [[nodiscard]] int row_count() const { return static_cast<int>(rows_.size()); }

  /// Field of `row` (from 0) in the named column. Throws std::out_of_range for an unknown column.
  [[nodiscard]] std::string_view field(int row, std::string_view column) const;

  /// All numbers of a column. Throws like `field` and `parse_number`.
  [[nodiscard]] std::vector<double> numbers(std::string_view column) const;

private:
  [[nodiscard]] std::size_t column_index(std::string_view column) const;

  std::vector<std::string_view> columns_;
  std::vector<std::vector<std::string_view>> rows_;
};

} // namespace abbe
