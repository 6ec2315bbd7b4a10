#include "spectral/illuminant.h"

#include "spectral/band_grid.h"
#include "spectral/data_table.h"
#include "spectral/observer.h"

#include <algorithm>

namespace abbe {
namespace {

struct Illuminant {
  std::string name;
  Curve curve;
};

Curve load(const DataTable& table) {
  const Curve native = Curve::table(table.numbers("nm"), table.numbers("spd"));
  std::vector<double> values(kSampleCount);
  for (int k = 0; k < kSampleCount; ++k)
    values[k] = native.at(sample_nm(k));
  const Curve samples = Curve::samples81(std::move(values));
  return samples.scaled(1.0 / to_xyz(samples).y);
}

// Each file of data/illuminants/ is one illuminant, named after it.
std::vector<Illuminant> load_illuminants() {
  constexpr std::string_view kFolder = "illuminants/";
  constexpr std::string_view kEnding = ".csv";
  std::vector<Illuminant> list;
  for (const auto& [file_name, text] : embedded_tables()) {
    if (!file_name.starts_with(kFolder)) continue;
    std::string_view name = file_name.substr(kFolder.size());
    name.remove_suffix(kEnding.size());
    // E is equal energy by definition; as a constant it costs nothing to multiply.
    const Curve curve = name == "E" ? Curve::constant(1.0) : load(DataTable(text));
    list.push_back({std::string(name), curve});
  }
  std::sort(list.begin(), list.end(),
            [](const Illuminant& a, const Illuminant& b) { return a.name < b.name; });
  return list;
}

const std::vector<Illuminant>& illuminants() {
  static const std::vector<Illuminant> list = load_illuminants();
  return list;
}

} // namespace

std::optional<Curve> find_illuminant(std::string_view name) {
  for (const Illuminant& illuminant : illuminants())
    if (same_name(illuminant.name, name)) return illuminant.curve;
  return std::nullopt;
}

std::vector<std::string> illuminant_names() {
  std::vector<std::string> names;
  for (const Illuminant& illuminant : illuminants())
    names.push_back(illuminant.name);
  return names;
}

} // namespace abbe
