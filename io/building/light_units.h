#pragma once

#include "core/scene/light.h"
#include "io/text/read_error.h"

#include <cstdint>

namespace abbe {

/// In what a light's strength is given. `factor` multiplies the value that its spectrum has; the
/// others make a picture in which 1 is a candela per square metre.
enum class LightUnit : std::uint8_t { factor, candela, lumen, watt, lux };

/// How strong a light is.
struct LightStrength {
  double amount = 1.0;
  LightUnit unit = LightUnit::factor;
};

/// Gives the light this strength. Points and spots that are given in other units than `factor` fall
/// off with the square of the distance. A watt is one of light between 380 and 780 nm. Throws
/// ReadError where a light of its kind has no such quantity.
void set_strength(const SourcePosition& where, Light& light, const LightStrength& strength,
                  double mm_per_unit);

} // namespace abbe
