#pragma once

#include "spectral/color_difference.h"
#include "spectral/correlated_temperature.h"
#include "spectral/dominant_wavelength.h"
#include "spectral/uniform_chromaticity.h"

#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// What can be said of a colour.
struct ColorFacts {
  Xyz xyz;
  std::optional<Chromaticity> xy; ///< none of black, and of what has no sum above 0
  std::optional<UniformChromaticity> uv;
  Lab lab;
  LinearRgb rgb;
  std::optional<DominantWavelength> dominant;
  std::optional<CorrelatedTemperature> temperature; ///< for the 2 degree observer alone
};

/// Under a white of Y = 1.
[[nodiscard]] ColorFacts color_facts(const Xyz& color, const Chromaticity& white,
                                     Observer observer);

/// One fact, as text for a table and as numbers for programs.
struct Fact {
  std::string name; ///< for tables: "x y"
  std::string key;  ///< for programs: "xy"
  std::vector<double> numbers;
  std::string text; ///< "-" where there is nothing to say
};
[[nodiscard]] std::vector<Fact> listed(const ColorFacts& facts);

/// The facts as members of an object of JSON, without its braces; what is not known is null.
[[nodiscard]] std::string json_members(const std::vector<Fact>& facts);

} // namespace abbe
