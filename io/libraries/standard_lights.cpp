// Lights that need no library, wherever a light is named:
//
//   background D65 0.1
//   light blackbody(2856)  0 5 0  1
//   light line(632.8)      1 0 0  0
//   light sodium           0 5 0  1

#include "io/libraries/standard_lights.h"

#include "io/text/read_arguments.h"
#include "spectral/data_table.h"
#include "spectral/illuminant.h"
#include "spectral/line_lamp.h"

#include <fmt/format.h>

namespace abbe {
namespace {

/// A light that takes a number.
struct LampLaw {
  std::string_view name, example;
  std::string_view meaning; ///< of the number
  double lowest, highest;
  Curve (*spectrum)(double);
};

constexpr LampLaw kLaws[] = {
    {"blackbody", "5778", "a temperature in kelvin", 500.0, 1e6, blackbody},
    {"daylight", "6500", "a correlated colour temperature in kelvin", 4000.0, 25000.0,
     cie_daylight},
    {"line", "632.8", "a wavelength in nm", 380.0, 780.0, line_lamp},
};
constexpr std::string_view kSodium = "sodium";

Curve read_law(const Token& name, const LampLaw& law, std::string_view text) {
  const auto right = fmt::format("Write it without spaces, such as {}({})", law.name, law.example);
  if (text.empty() || text.back() != ')')
    throw ReadError(name.where, fmt::format("\")\" is missing in {}", shown(name)),
                    fmt::format("{} takes {}", law.name, law.meaning), right);
  text.remove_suffix(1);
  const auto value = parse_finite(text);
  if (!value)
    throw ReadError(name.where, fmt::format("\"{}\" is not a number", text),
                    fmt::format("{} takes {}", law.name, law.meaning), right);
  if (*value < law.lowest || *value > law.highest)
    throw ReadError(name.where, fmt::format("{} is out of range for {}", text, law.name),
                    fmt::format("it is {}", law.meaning),
                    fmt::format("Give a number from {} to {}", law.lowest, law.highest));
  return law.spectrum(*value);
}

/// The law whose name stands before the bracket; null when there is none.
const LampLaw* find_law(std::string_view text) {
  const std::size_t bracket = text.find('(');
  if (bracket == std::string_view::npos) return nullptr;
  for (const LampLaw& law : kLaws)
    if (same_name(law.name, text.substr(0, bracket))) return &law;
  return nullptr;
}

} // namespace

std::optional<Curve> standard_light(const Token& name) {
  const std::string_view text = name.text;
  if (const auto illuminant = find_illuminant(text)) return illuminant;
  if (same_name(kSodium, text)) return sodium_lamp();
  if (const LampLaw* law = find_law(text))
    return read_law(name, *law, text.substr(law->name.size() + 1));
  return std::nullopt;
}

bool is_standard_light(std::string_view name) {
  return find_illuminant(name) || same_name(kSodium, name) || find_law(name) != nullptr;
}

std::vector<std::string> standard_light_names() {
  std::vector<std::string> names = illuminant_names();
  names.emplace_back(kSodium);
  for (const LampLaw& law : kLaws)
    names.push_back(fmt::format("{}({})", law.name, law.example));
  return names;
}

} // namespace abbe
