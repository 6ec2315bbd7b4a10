#include "spectral/glass.h"

#include "spectral/data_table.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

// glass.csv gives each law as a kind and a list of numbers, wavelengths in um; its first line
// states the formulas. The functions below cut a list into the coefficients of one law.
using Numbers = std::vector<double>;

int whole(double value) {
  const int rounded = static_cast<int>(std::lround(value));
  if (rounded != value) throw std::invalid_argument("an exponent in glass.csv is not whole");
  return rounded;
}

void require_groups(const Numbers& c, std::size_t size) {
  if (c.empty() || (c.size() - 1) % size != 0)
    throw std::invalid_argument("glass.csv has a row with a wrong number of coefficients");
}

// `squared` tells whether the file stores C or its square root.
Dispersion read_sellmeier(const Numbers& c, bool squared) {
  require_groups(c, 2);
  Sellmeier law{c[0], {}};
  for (std::size_t i = 1; i < c.size(); i += 2)
    law.terms.push_back({c[i], squared ? c[i + 1] : c[i + 1] * c[i + 1]});
  return law;
}

std::vector<PowerTerm> read_powers(const Numbers& c, std::size_t first) {
  std::vector<PowerTerm> terms;
  for (std::size_t i = first; i + 1 < c.size(); i += 2)
    terms.push_back({c[i], whole(c[i + 1])});
  return terms;
}

Dispersion read_power_series(const Numbers& c) {
  require_groups(c, 2);
  return PowerSeries{c[0], read_powers(c, 1)};
}

Dispersion read_formula4(const Numbers& c) {
  require_groups(c, 2);
  Formula4 law{c[0], {}, {}};
  // Two groups (coefficient, exponent, base, exponent of base), then powers as far as they go.
  for (std::size_t i = 1; i < 9 && i + 3 < c.size(); i += 4)
    if (c[i] != 0.0) law.poles.push_back({c[i], whole(c[i + 1]), std::pow(c[i + 2], c[i + 3])});
  law.powers = read_powers(c, 9);
  return law;
}

Dispersion read_gas(const Numbers& c) {
  require_groups(c, 2);
  GasFormula law{c[0], {}};
  for (std::size_t i = 1; i < c.size(); i += 2)
    law.terms.push_back({c[i], c[i + 1]});
  return law;
}

Dispersion read_law(std::string_view kind, std::string_view coefficients) {
  Numbers numbers;
  for (const std::string_view word : split_words(coefficients))
    numbers.push_back(parse_number(word));
  if (kind == "sellmeier") return read_sellmeier(numbers, true);
  if (kind == "sellmeier_sqC") return read_sellmeier(numbers, false);
  if (kind == "poly_n2") return read_power_series(numbers);
  if (kind == "ri_formula4") return read_formula4(numbers);
  if (kind == "gas") return read_gas(numbers);
  throw std::invalid_argument("glass.csv has an unknown kind " + std::string(kind));
}

std::optional<double> read_optional(std::string_view text) {
  if (text.empty()) return std::nullopt;
  return parse_number(text);
}

std::vector<Glass> load_glasses() {
  const DataTable table{embedded_table("glass.csv")};
  std::vector<Glass> list;
  for (int row = 0; row < table.row_count(); ++row) {
    const auto field = [&](std::string_view column) { return table.field(row, column); };
    list.push_back({std::string(field("name")), read_law(field("kind"), field("coefficients")),
                    parse_number(field("lo_um")) * 1e3, parse_number(field("hi_um")) * 1e3,
                    std::string(field("reference")), read_optional(field("nd_published")),
                    read_optional(field("Vd_published")), std::string(field("published_from"))});
  }
  return list;
}

/// What people call materials that the catalogue has under a longer name.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kGlassNames{{
    {"water", "water-20C"},
    {"air", "air-15C"},
    {"window", "soda-lime"},
    {"window-glass", "soda-lime"},
    {"zirconia", "zirconia-cubic"},
    {"cubic-zirconia", "zirconia-cubic"},
    {"sapphire", "sapphire-o"},
    {"ruby", "sapphire-o"},
    {"quartz", "crystal-quartz-o"},
    {"silica", "fused-silica"},
    {"calcite", "calcite-o"},
    {"fluorite", "CaF2"},
    {"salt", "NaCl"},
    {"rutile", "TiO2-rutile-o"},
    {"plexiglass", "PMMA"},
}};

} // namespace

const std::vector<Glass>& glass_catalogue() {
  static const std::vector<Glass> list = load_glasses();
  return list;
}

const Glass* find_glass(std::string_view name) {
  for (const Glass& glass : glass_catalogue())
    if (same_name(glass.name, name)) return &glass;
  for (const auto& [common, in_catalogue] : kGlassNames)
    if (same_name(common, name)) return find_glass(in_catalogue);
  return nullptr;
}

} // namespace abbe
