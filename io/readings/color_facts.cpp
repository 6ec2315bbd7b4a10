#include "io/readings/color_facts.h"

#include "io/text/json.h"

#include <fmt/format.h>

#include <cmath>

namespace abbe {
namespace {

std::string text_of(const DominantWavelength& dominant) {
  return fmt::format("{:.2f} nm{}, purity {:.4f}", dominant.nm,
                     dominant.complementary ? " (complementary: this is a purple)" : "",
                     dominant.purity);
}

std::string text_of(const CorrelatedTemperature& temperature) {
  return fmt::format("{:.0f} K, Duv {:+.5f}", temperature.kelvin, temperature.duv);
}

} // namespace

ColorFacts color_facts(const Xyz& color, const Chromaticity& white, Observer observer) {
  ColorFacts facts;
  facts.xyz = color;
  facts.lab = to_lab(color, to_xyz(white, 1.0));
  facts.rgb = to_linear_srgb(color);
  const double sum = color.x + color.y + color.z;
  if (!(sum > 0.0) || !std::isfinite(sum)) return facts;
  facts.xy = chromaticity(color);
  facts.uv = uniform(*facts.xy);
  facts.dominant = dominant_wavelength(*facts.xy, white, observer);
  if (observer == Observer::cie1931_2deg) facts.temperature = correlated_temperature(*facts.xy);
  return facts;
}

std::vector<Fact> listed(const ColorFacts& f) {
  const auto numbers = [](const std::vector<double>& values, int digits) {
    std::string text;
    for (const double value : values)
      text += fmt::format("{}{:.{}f}", text.empty() ? "" : "  ", value, digits);
    return text;
  };
  std::vector<Fact> facts;
  const auto add = [&](const char* name, const char* key, std::vector<double> values, int digits) {
    std::string text = values.empty() ? "-" : numbers(values, digits);
    facts.push_back({name, key, std::move(values), std::move(text)});
  };
  using Values = std::vector<double>;
  add("X Y Z", "XYZ", {f.xyz.x, f.xyz.y, f.xyz.z}, 6);
  add("x y", "xy", f.xy ? Values{f.xy->x, f.xy->y} : Values{}, 5);
  add("u' v'", "uv", f.uv ? Values{f.uv->u, f.uv->v} : Values{}, 5);
  add("L* a* b*", "Lab", {f.lab.l, f.lab.a, f.lab.b}, 3);
  add("linear sRGB", "RGB", {f.rgb.r, f.rgb.g, f.rgb.b}, 5);
  facts.push_back({"dominant wavelength", "dominant_nm",
                   f.dominant ? Values{f.dominant->nm} : Values{},
                   f.dominant ? text_of(*f.dominant) : "-"});
  facts.push_back({"correlated temperature", "cct_K",
                   f.temperature ? Values{f.temperature->kelvin} : Values{},
                   f.temperature ? text_of(*f.temperature) : "-"});
  // For programs alone: they stand in the texts above.
  facts.push_back({"", "purity", f.dominant ? Values{f.dominant->purity} : Values{}, ""});
  facts.push_back({"", "complementary",
                   f.dominant ? Values{f.dominant->complementary ? 1.0 : 0.0} : Values{}, ""});
  facts.push_back({"", "duv", f.temperature ? Values{f.temperature->duv} : Values{}, ""});
  return facts;
}

std::string json_members(const std::vector<Fact>& facts) {
  std::string json;
  for (const Fact& fact : facts) {
    std::string value = "null";
    if (fact.numbers.size() == 1) value = json_number(fact.numbers.front());
    if (fact.numbers.size() > 1) {
      value.clear();
      for (const double number : fact.numbers)
        value += (value.empty() ? "[" : ", ") + json_number(number);
      value += "]";
    }
    json += fmt::format("{}{}: {}", json.empty() ? "" : ", ", json_string(fact.key), value);
  }
  return json;
}

} // namespace abbe
