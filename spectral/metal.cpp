#include "spectral/metal.h"

#include "spectral/data_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace abbe {
namespace {

// Each file of data/conductors/ is one metal, named after it.
std::vector<Metal> load_metals() {
  constexpr std::string_view kFolder = "conductors/";
  constexpr std::string_view kEnding = ".csv";
  std::vector<Metal> list;
  for (const auto& [file_name, text] : embedded_tables()) {
    if (!file_name.starts_with(kFolder)) continue;
    std::string_view symbol = file_name.substr(kFolder.size());
    symbol.remove_suffix(kEnding.size());
    const DataTable table(text);
    const std::vector<double> nm = table.numbers("nm");
    list.push_back({std::string(symbol), Curve::table(nm, table.numbers("n")),
                    Curve::table(nm, table.numbers("k"))});
  }
  std::sort(list.begin(), list.end(),
            [](const Metal& a, const Metal& b) { return a.name < b.name; });
  return list;
}

/// What people call metals.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kMetalNames{{
    {"silver", "Ag"},
    {"gold", "Au"},
    {"copper", "Cu"},
    {"chromium", "Cr"},
    {"chrome", "Cr"},
    {"iron", "Fe"},
    {"nickel", "Ni"},
    {"titanium", "Ti"},
    {"aluminium", "Al"},
    {"aluminum", "Al"},
    {"platinum", "Pt"},
}};

} // namespace

const std::vector<Metal>& metal_catalogue() {
  static const std::vector<Metal> list = load_metals();
  return list;
}

const Metal* find_metal(std::string_view symbol) {
  for (const Metal& metal : metal_catalogue())
    if (same_name(metal.name, symbol)) return &metal;
  for (const auto& [common, in_catalogue] : kMetalNames)
    if (same_name(common, symbol)) return find_metal(in_catalogue);
  return nullptr;
}

} // namespace abbe
