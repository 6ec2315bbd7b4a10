#pragma once

#include "spectral/data_table.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace abbe::test {

/// A table of expected values from tests/spectral/data/, or from spectral/data/expected/ if the
/// program itself shows them too (`abbe selftest`), with the text its fields point into.
class Expected {
public:
  explicit Expected(const std::string& file_name) : text_(read(file_name)), table_(text_) {}
  Expected(const Expected&) = delete;
  Expected& operator=(const Expected&) = delete;

  int row_count() const { return table_.row_count(); }
  std::string text(int row, std::string_view column) const {
    return std::string(table_.field(row, column));
  }
  double number(int row, std::string_view column) const {
    return parse_number(table_.field(row, column));
  }
  std::vector<double> numbers(std::string_view column) const { return table_.numbers(column); }

private:
  static std::string read(const std::string& file_name) {
    std::ifstream file(ABBE_SOURCE_DIR "/tests/spectral/data/" + file_name);
    if (!file) file.open(ABBE_SOURCE_DIR "/spectral/data/expected/" + file_name);
    if (!file) throw std::runtime_error("cannot read " + file_name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  std::string text_;
  DataTable table_;
};

} // namespace abbe::test
