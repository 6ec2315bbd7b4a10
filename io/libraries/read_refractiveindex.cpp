// Files of refractiveindex.info, of whose YAML this much is read:
//
//   DATA:
//     - type: formula 2
//       wavelength_range: 0.3 2.5
//       coefficients: 0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653
//     - type: tabulated k
//       data: |
//           0.3 2.86e-6
//           0.31 1.37e-6
//
// A type is formula 1 to 9, or tabulated n, k or nk. Wavelengths are in um.

#include "io/libraries/glass_formulas.h"
#include "io/libraries/read_glass_files.h"
#include "io/text/numbers.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// One item of DATA.
struct Item {
  SourcePosition where;
  std::string type;
  std::vector<double> coefficients, range;
  std::vector<std::vector<double>> rows;
};

/// Cuts a file into the items of its DATA.
class ItemReader {
public:
  ItemReader(std::string_view text, const fs::path& file)
      : rest_(text), where_{file.string(), 0, 1} {}

  std::vector<Item> read() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      read_line(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
    }
    return std::move(items_);
  }

private:
  void read_line(std::string_view line) {
    ++where_.line;
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string_view::npos) return;
    std::string_view text = line.substr(indent);
    if (indent == 0 && !text.starts_with('-')) in_data_ = text.starts_with("DATA:");
    if (!in_data_ || text.starts_with('#')) return;
    if (text.starts_with("- ")) {
      items_.push_back({where_, {}, {}, {}, {}});
      text = text.substr(std::min(text.find_first_not_of(' ', 1), text.size()));
      in_table_ = false;
    }
    if (items_.empty()) return;
    const std::size_t colon = text.find(':');
    if (in_table_ && colon == std::string_view::npos)
      return items_.back().rows.push_back(numbers(text));
    if (colon == std::string_view::npos) return;
    read_key(text.substr(0, colon), text.substr(colon + 1));
  }

  void read_key(std::string_view key, std::string_view value) {
    Item& item = items_.back();
    in_table_ = key == "data";
    if (key == "type") {
      const std::vector<std::string_view> words = split_words(value);
      for (const std::string_view word : words)
        item.type += (item.type.empty() ? "" : " ") + std::string(word);
    } else if (key == "coefficients") {
      item.coefficients = numbers(value);
    } else if (key == "wavelength_range" || key == "range") {
      item.range = numbers(value);
    }
  }

  [[nodiscard]] std::vector<double> numbers(std::string_view text) const {
    std::vector<double> found;
    std::string blanks(text);
    std::ranges::replace(blanks, '\t', ' ');
    for (const std::string_view word : split_words(blanks)) {
      const auto value = parse_finite(word);
      if (!value)
        throw ReadError(where_, fmt::format("\"{}\" is not a number", word),
                        "one should stand here", "Get the file from refractiveindex.info again");
      found.push_back(*value);
    }
    return found;
  }

  std::string_view rest_;
  SourcePosition where_;
  bool in_data_ = false, in_table_ = false;
  std::vector<Item> items_;
};

/// A column of a table, with the wavelengths in nm.
struct Column {
  std::vector<double> nm, values;
};

Column column(const Item& item, std::size_t number) {
  Column found;
  for (const std::vector<double>& row : item.rows) {
    if (row.size() <= number)
      throw ReadError(item.where,
                      fmt::format("a row of \"{}\" has {} columns", item.type, row.size()),
                      fmt::format("{} should stand there", number + 1),
                      "Get the file from refractiveindex.info again");
    // Some files give a wavelength twice, where two measurements meet.
    if (!found.nm.empty() && 1e3 * row[0] <= found.nm.back()) continue;
    found.nm.push_back(1e3 * row[0]);
    found.values.push_back(row[number]);
  }
  if (found.nm.empty())
    throw ReadError(item.where, fmt::format("\"{}\" has no rows", item.type), "data should follow",
                    "Get the file from refractiveindex.info again");
  return found;
}

void take_table(const Item& item, std::string_view what, RefractiveIndexFile& file) {
  if (what.starts_with('n')) {
    Column n = column(item, 1);
    file.lower_nm = n.nm.front();
    file.upper_nm = n.nm.back();
    file.n_table = Curve::table(n.nm, n.values);
    file.n = tabulated_index(std::move(n.nm), std::move(n.values));
  }
  if (what.ends_with('k')) {
    Column k = column(item, what == "nk" ? 2 : 1);
    for (double& value : k.values)
      value = std::max(value, 0.0);
    file.k = Curve::table(std::move(k.nm), std::move(k.values));
  }
}

void take_formula(const Item& item, int number, RefractiveIndexFile& file) {
  if (item.range.size() == 2) {
    file.lower_nm = 1e3 * item.range[0];
    file.upper_nm = 1e3 * item.range[1];
  }
  try {
    file.n = refractiveindex_law(number, item.coefficients);
  } catch (const std::invalid_argument& fault) {
    throw ReadError(item.where, fmt::format("\"{}\" gives no index", item.type), fault.what(),
                    "Give a substance that is known in visible light");
  }
}

RefractiveIndexFile read_named(const Token& name) {
  const fs::path file = fs::path(name.where.file).parent_path() / name.text;
  std::error_code error;
  if (!fs::exists(file, error))
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "it is found relative to the file that names it",
                    "Check the name, or write the whole path");
  return read_refractiveindex_text(read_text_file(file), file);
}

} // namespace

bool is_refractiveindex_file(std::string_view name) {
  const std::string extension = fs::path(name).extension().string();
  return same_name(extension, ".yml") || same_name(extension, ".yaml");
}

RefractiveIndexFile read_refractiveindex_text(std::string_view text, const fs::path& file) {
  RefractiveIndexFile found;
  for (const Item& item : ItemReader(text, file).read()) {
    constexpr std::string_view kFormula = "formula ", kTable = "tabulated ";
    if (item.type.starts_with(kFormula)) {
      const auto number = parse_whole(std::string_view(item.type).substr(kFormula.size()));
      take_formula(item, static_cast<int>(std::clamp<std::int64_t>(number.value_or(0), 0, 99)),
                   found);
    } else if (item.type.starts_with(kTable)) {
      take_table(item, std::string_view(item.type).substr(kTable.size()), found);
    }
  }
  if (!found.n)
    throw ReadError(file, "the file gives no refractive index",
                    "no item of its DATA has the type formula, tabulated n or tabulated nk",
                    "Give a file of refractiveindex.info with n");
  return found;
}

FileGlass read_refractiveindex_glass(const Token& name) {
  RefractiveIndexFile file = read_named(name);
  FileGlass found;
  found.glass.name = fs::path(name.text).stem().string();
  found.glass.dispersion = std::move(*file.n);
  found.glass.lower_nm = file.lower_nm;
  found.glass.upper_nm = file.upper_nm;
  found.glass.source = name.text;
  if (!file.k) return found;
  // Amplitude falls as exp(-2 pi k x / lambda), and power as its square.
  std::vector<double> nm, per_mm;
  for (double at = 360.0; at <= 800.0; at += 1.0) {
    nm.push_back(at);
    per_mm.push_back(4.0 * std::numbers::pi * file.k->at(at) / (1e-6 * at));
  }
  found.absorption_per_mm = Curve::table(std::move(nm), std::move(per_mm));
  return found;
}

ConductorIndex read_refractiveindex_metal(const Token& name) {
  RefractiveIndexFile file = read_named(name);
  if (!file.k || !file.n_table)
    throw ReadError(name.where, fmt::format("{} is no metal", shown(name)),
                    "a metal has both n and k in tables", "Give a file with n and k, or a glass");
  return {std::move(*file.n_table), std::move(*file.k)};
}

} // namespace abbe
