#include "io/selftest/chart_rows.h"

#include "io/selftest/small_picture.h"
#include "spectral/color_difference.h"
#include "spectral/data_table.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace abbe {
namespace {

constexpr int kColumns = 6, kPatches = 24;

/// Squares side by side, each as large as a pixel of the picture, under a parallel lamp that faces
/// them. Each patch sends out its reflectance times the lamp's spectrum.
Film chart(const std::string& illuminant) {
  std::string text = fmt::format("eye 0 0 100 lookAt 0 0 0 imageSize {} {} filter box samples 1 "
                                 "fieldOfView 4.581195 background 0 0 0 light {} 0 0 1 0\n",
                                 kColumns, kPatches / kColumns, illuminant);
  for (int i = 0; i < kPatches; ++i) { // shades of grey, to be replaced, as equal finishes are one
    const double grey = 0.01 * (i + 1);
    text += fmt::format("push defaultMaterials ambient 0 0 0 specular 0 0 0 diffuse {0} {0} {0} "
                        "translate {1} {2} 0 square pop\n",
                        grey, 2 * (i % kColumns) - 5, 3 - 2 * (i / kColumns));
  }
  Scene scene = scene_of_text(text);
  const DataTable patches(embedded_table("expected/colorchecker_ohta.csv"));
  for (std::size_t i = 0; i < kPatches; ++i) {
    Material& material = scene.materials.at(scene.shapes.at(i).material.index());
    material.diffuse = Curve::samples81(patches.numbers(fmt::format("p{:02}", i + 1)));
  }
  return std::move(rendered(scene).film);
}

} // namespace

SelftestRows chart_rows() {
  const DataTable expected(embedded_table("expected/golden_colorchecker.csv"));
  SelftestRows rows;
  for (const std::string illuminant : {"D65", "A"}) {
    const Film film = chart(illuminant);
    const Xyz white = to_xyz(find_illuminant(illuminant).value());
    for (int row = 0; row < expected.row_count(); ++row) {
      const auto value = [&](const char* column) {
        return parse_number(expected.field(row, column));
      };
      const int patch = static_cast<int>(value("patch")) - 1;
      if (expected.field(row, "illuminant") != illuminant || patch < 0) continue;
      const Lab seen = to_lab(film.color(patch % kColumns, patch / kColumns), white);
      rows.push_back({"chart",
                      fmt::format("{} under {}, dE2000", expected.field(row, "name"), illuminant),
                      "Ohta's reflectances, CIE 15", 0.0,
                      delta_e_2000(seen, {value("L"), value("a"), value("b")}), 1e-4});
    }
  }
  return rows;
}

} // namespace abbe
