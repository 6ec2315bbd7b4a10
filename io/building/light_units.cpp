#include "io/building/light_units.h"

#include "spectral/band_grid.h"
#include "spectral/observer.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

namespace abbe {
namespace {

using std::numbers::pi;

std::string_view name_of(LightUnit unit) {
  switch (unit) {
  case LightUnit::factor:
    return "intensity";
  case LightUnit::candela:
    return "candela";
  case LightUnit::lumen:
    return "lumen";
  case LightUnit::watt:
    return "watt";
  case LightUnit::lux:
    return "lux";
  }
  return "";
}

/// Watts of light between 380 and 780 nm, in the unit of the curve.
double power(const Curve& spectrum) {
  double watts = 0.0;
  for (const SpectralLine& line : spectrum.spectral_lines())
    watts += line.power;
  if (!spectrum.spectral_lines().empty()) return watts;
  const Curve samples = spectrum.sampled81();
  for (int k = 0; k < kSampleCount; ++k) // half of the first and the last cell lie outside
    watts += samples.at(sample_nm(k)) * (k == 0 || k == kSampleCount - 1 ? 2.5 : 5.0);
  return watts;
}

/// Lumens per watt: 683 times the part of the light that is seen.
double efficacy(const Curve& spectrum) {
  // Y = 1 is the light of value 1 at all wavelengths, of which 106.857 nm are seen [CIE15].
  constexpr double kSeenNm = 106.857;
  return 683.0 * kSeenNm * to_xyz(spectrum).y / power(spectrum);
}

/// The solid angle of a spot, each direction counted as far as it is lit.
double lit_solid_angle(const SpotLight& spot) {
  const double full = 2.0 * pi * (1.0 - std::cos(spot.full_angle));
  const double edge = spot.half_angle - spot.full_angle;
  if (!(edge > 0.0)) return full;
  constexpr int kSteps = 2000; // the middles of so many rings
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = (i + 0.5) / kSteps;
    sum += x * x * (3.0 - 2.0 * x) * std::sin(spot.half_angle - x * edge);
  }
  return full + 2.0 * pi * sum * edge / kSteps;
}

[[noreturn]] void fail(const SourcePosition& where, LightUnit unit, const std::string& why,
                       const std::string& right) {
  throw ReadError(where, fmt::format("{} does not go with this light", name_of(unit)), why, right);
}

/// The luminous intensity in candela of a light that shines from a point.
double candelas(const SourcePosition& where, const LightStrength& strength, const Light& light,
                double solid_angle) {
  switch (strength.unit) {
  case LightUnit::candela:
    return strength.amount;
  case LightUnit::lumen:
    return strength.amount / solid_angle;
  case LightUnit::watt:
    return strength.amount * efficacy(light.spectrum) / solid_angle;
  case LightUnit::factor:
  case LightUnit::lux:
    break;
  }
  fail(where, strength.unit, "how bright it is depends on the distance",
       "Give candela, lumen or watt");
}

/// What the spectrum of a light is to have as its Y.
double value_of(const SourcePosition& where, const LightStrength& strength, Light& light,
                double mm_per_unit) {
  const double units_per_metre = 1000.0 / mm_per_unit; // its intensity counts in scene units
  if (auto* lamp = std::get_if<PointLight>(&light.kind)) {
    lamp->falloff = Falloff::square;
    return candelas(where, strength, light, 4.0 * pi) * units_per_metre * units_per_metre;
  }
  if (auto* spot = std::get_if<SpotLight>(&light.kind)) {
    spot->falloff = Falloff::square;
    return candelas(where, strength, light, lit_solid_angle(*spot)) * units_per_metre *
           units_per_metre;
  }
  if (strength.unit != LightUnit::lux)
    fail(where, strength.unit, "it comes from infinitely far, and has no flux of its own",
         "Give lux, what falls on a surface that faces it");
  return strength.amount / pi;
}

} // namespace

void set_strength(const SourcePosition& where, Light& light, const LightStrength& strength,
                  double mm_per_unit) {
  if (strength.unit == LightUnit::factor) {
    light.spectrum = light.spectrum.scaled(strength.amount);
    return;
  }
  const double y = to_xyz(light.spectrum).y;
  if (!(y > 0.0)) fail(where, strength.unit, "nobody can see its spectrum", "Give intensity");
  light.spectrum = light.spectrum.scaled(value_of(where, strength, light, mm_per_unit) / y);
}

} // namespace abbe
