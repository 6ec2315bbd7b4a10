#include "spectral/data_table.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string>
#include <utility>

namespace abbe {
namespace {

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find(separator);
    fields.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::string_view embedded_table(std::string_view file_name) {
  for (const EmbeddedTable& table : embedded_tables())
    if (table.file_name == file_name) return table.text;
  throw std::out_of_range("no compiled-in table " + std::string(file_name));
}

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

double parse_number(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end)
    throw std::invalid_argument("not a number: '" + std::string(text) + "'");
  return value;
}

std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words = split(text, ' ');
  std::erase_if(words, [](std::string_view word) { return word.empty(); });
  return words;
}

DataTable::DataTable(std::string_view text) {
  int line_number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++line_number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string_view> fields = split(line, ',');
    if (columns_.empty()) {
      columns_ = std::move(fields);
      continue;
    }
    if (fields.size() != columns_.size())
      throw std::invalid_argument("line " + std::to_string(line_number) + " has " +
                                  std::to_string(fields.size()) + " fields, the header has " +
                                  std::to_string(columns_.size()));
    rows_.push_back(std::move(fields));
  }
  if (columns_.empty()) throw std::invalid_argument("the table has no header line");
}

std::string_view DataTable::field(int row, std::string_view column) const {
  return rows_.at(row)[column_index(column)];
}

std::vector<double> DataTable::numbers(std::string_view column) const {
  const std::size_t index = column_index(column);
  std::vector<double> values;
  values.reserve(rows_.size());
  for (const auto& row : rows_)
    values.push_back(parse_number(row[index]));
  return values;
}

std::size_t DataTable::column_index(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) throw std::out_of_range("no column " + std::string(column));
  return static_cast<std::size_t>(found - columns_.begin());
}

} // namespace abbe
