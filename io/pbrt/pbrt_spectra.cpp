// Spectra, in a parameter of the type rgb, blackbody, spectrum or float:
//
//   "rgb reflectance" [ 0.8 0.2 0.1 ]          "blackbody L" 3000
//   "spectrum eta" "glass-BK7"                 "spectrum L" [ 400 0.5  700 1 ]

#include "core/scene/quantity_limits.h"
#include "io/libraries/read_spectrum.h"
#include "io/pbrt/pbrt_state.h"
#include "io/text/similar_names.h"
#include "spectral/data_table.h"
#include "spectral/glass.h"
#include "spectral/illuminant.h"
#include "spectral/metal.h"
#include "spectral/observer.h"
#include "spectral/radiator.h"
#include "spectral/rgb_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace abbe {
namespace {

/// pbrt's names of glasses, and ours.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kGlasses{{
    {"glass-BK7", "N-BK7"},
    {"glass-BAF10", "N-BAF10"},
    {"glass-FK51A", "N-FK51A"},
    {"glass-LASF9", "LASFN9"},
    {"glass-F5", "F5"},
    {"glass-SF5", "SF5"},
    {"glass-SF10", "SF10"},
    {"glass-SF11", "SF11"},
}};

const Glass* named_glass(std::string_view name) {
  for (const auto& [theirs, ours] : kGlasses)
    if (name == theirs) return find_glass(ours);
  return nullptr;
}

/// stdillum-D65, and stdillum-F2, which is FL2.
std::optional<Curve> named_illuminant(std::string_view name) {
  constexpr std::string_view kPrefix = "stdillum-";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  name.remove_prefix(kPrefix.size());
  if (const auto found = find_illuminant(name)) return found;
  if (name.starts_with('F')) return find_illuminant("FL" + std::string(name.substr(1)));
  return std::nullopt;
}

/// metal-Cu-eta or metal-Cu-k.
std::optional<Curve> named_metal(std::string_view name) {
  constexpr std::string_view kPrefix = "metal-";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  name.remove_prefix(kPrefix.size());
  const std::size_t dash = name.find('-');
  const Metal* metal = find_metal(name.substr(0, dash));
  if (!metal || dash == std::string_view::npos) return std::nullopt;
  return name.substr(dash) == "-k" ? metal->k : metal->n;
}

/// Pairs of a wavelength and a value, held beyond their ends.
Curve pairs(const PbrtParameter& parameter) {
  const std::vector<double>& numbers = parameter.numbers;
  std::vector<double> nm, values;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    if (!nm.empty() && !(numbers[i] > nm.back()))
      throw ReadError(parameter.where,
                      fmt::format("the wavelengths of {} do not ascend", parameter.name),
                      fmt::format("{:g} follows {:g}", numbers[i], nm.back()),
                      "Sort the pairs of wavelength and value");
    nm.push_back(numbers[i]);
    values.push_back(numbers[i + 1]);
  }
  if (nm.empty() || numbers.size() % 2 != 0)
    throw ReadError(
        parameter.where, fmt::format("{} is no spectrum", parameter.name),
        fmt::format("{} numbers are not pairs of a wavelength and a value", numbers.size()),
        "Give nm and value in turn, or the name of a spectrum");
  if (std::ranges::all_of(values, [&](double v) { return v == values[0]; }))
    return Curve::constant(values[0]);
  return Curve::table(std::move(nm), std::move(values));
}

Curve spectrum_of_file(PbrtState& state, const PbrtParameter& parameter) {
  const std::filesystem::path file = state.folder / parameter.strings[0];
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw ReadError(parameter.where, fmt::format("unknown spectrum \"{}\"", parameter.strings[0]),
                    "it is no name that is known, and no file found from the scene's folder",
                    "stdillum-D65, glass-BK7 and metal-Cu-eta are such names");
  state.files.push_back(file);
  MeasuredSpectrum found = read_spectrum_text(read_text_file(file), file, state.warn);
  return Curve::table(std::move(found.nm), std::move(found.values));
}

LinearRgb rgb_of(const PbrtParameter& parameter) {
  if (parameter.numbers.size() != 3)
    throw ReadError(parameter.where, fmt::format("{} is no colour", parameter.name),
                    fmt::format("{} numbers follow", parameter.numbers.size()),
                    "Give red, green and blue");
  for (const double part : parameter.numbers)
    if (part < 0.0)
      throw ReadError(parameter.where, fmt::format("{} has a part below 0", parameter.name),
                      "light is never negative", "Give 0 or more");
  return {parameter.numbers[0], parameter.numbers[1], parameter.numbers[2]};
}

/// A spectrum of any type but rgb, as it stands.
Curve plain(PbrtState& state, const PbrtParameter& parameter) {
  if (parameter.type == "blackbody" && parameter.numbers.size() == 1) {
    if (!(parameter.numbers[0] >= 500.0 && parameter.numbers[0] <= 1e6))
      throw ReadError(parameter.where, "a black body is too cold or too hot",
                      "it has from 500 to 1000000 kelvin", "Give a temperature in kelvin");
    return blackbody(parameter.numbers[0]);
  }
  if (parameter.strings.size() == 1) {
    const std::string& name = parameter.strings[0];
    if (const auto found = named_illuminant(name)) return *found;
    if (const auto found = named_metal(name)) return *found;
    return spectrum_of_file(state, parameter);
  }
  if (parameter.numbers.size() == 1) return Curve::constant(parameter.numbers[0]);
  return pairs(parameter);
}

} // namespace

PbrtTexture read_reflectance(PbrtState& state, PbrtParameters& parameters, std::string_view name,
                             double otherwise) {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return {Curve::constant(otherwise), std::nullopt};
  if (found->type == "texture") {
    const auto texture =
        state.textures.find(found->strings.size() == 1 ? found->strings[0] : std::string());
    if (texture == state.textures.end())
      throw ReadError(found->where, fmt::format("{} names no texture", name),
                      "no texture of this name has been given before", "Check the name");
    return texture->second;
  }
  if (found->type == "rgb") {
    const LinearRgb rgb = rgb_of(*found);
    return {rgb_reflectance({std::min(rgb.r, 1.0), std::min(rgb.g, 1.0), std::min(rgb.b, 1.0)}),
            std::nullopt};
  }
  return {within_one(plain(state, *found)), std::nullopt};
}

Curve within_one(const Curve& curve) {
  if (const auto value = curve.constant_value())
    return Curve::constant(std::clamp(*value, 0.0, 1.0));
  const Curve sampled = curve.sampled81();
  std::vector<double> values;
  for (int k = 0; k < kSampleCount; ++k)
    values.push_back(std::clamp(sampled.at(sample_nm(k)), 0.0, 1.0));
  return Curve::samples81(std::move(values));
}

Curve read_light_spectrum(PbrtState& state, PbrtParameters& parameters, std::string_view name) {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return *find_illuminant("D65");
  if (found->type == "rgb") return rgb_emission(rgb_of(*found));
  const Curve curve = plain(state, *found);
  const double y = to_xyz(curve).y;
  if (y == 0.0) return Curve::constant(0.0);
  if (!(y > 0.0 && std::isfinite(1.0 / y)))
    throw ReadError(found->where, fmt::format("{} is no light", name), "its luminance is below 0",
                    "Give values of 0 or more");
  return curve.scaled(1.0 / y);
}

std::optional<Curve> read_plain_spectrum(PbrtState& state, PbrtParameters& parameters,
                                         std::string_view name) {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return std::nullopt;
  if (found->type == "rgb") { // not bounded by 1, as a reflectance is
    const LinearRgb rgb = rgb_of(*found);
    const double most = std::max({rgb.r, rgb.g, rgb.b});
    if (most == 0.0) return Curve::constant(0.0);
    return rgb_reflectance({rgb.r / most, rgb.g / most, rgb.b / most}).scaled(most);
  }
  return plain(state, *found);
}

Dispersion read_index(PbrtState& state, PbrtParameters& parameters, std::string_view name,
                      double otherwise) {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return ConstantIndex{otherwise};
  if (found->strings.size() == 1)
    if (const Glass* glass = named_glass(found->strings[0])) {
      state.builder.warn_of_extrapolation(found->where, *glass, state.warn);
      return glass->dispersion;
    }
  const Curve curve = plain(state, *found);
  for (int k = -1; k <= 81; ++k)
    if (const double n = curve.at(380.0 + 5.0 * k); !(n >= kLeastIndex && n <= kMostIndex))
      throw ReadError(found->where, fmt::format("{} is no refractive index", name),
                      fmt::format("it is {:g} at {} nm, and lies from {} to {}", n, 380 + 5 * k,
                                  kLeastIndex, kMostIndex),
                      "Change it");
  if (const auto n = curve.constant_value()) return ConstantIndex{*n};
  std::vector<double> nm, n;
  for (std::size_t i = 0; i + 1 < found->numbers.size(); i += 2) {
    nm.push_back(found->numbers[i]);
    n.push_back(found->numbers[i + 1]);
  }
  if (!nm.empty()) return tabulated_index(std::move(nm), std::move(n));
  for (int k = -4; k <= 84; ++k) { // a file, of which the curve is at hand
    nm.push_back(380.0 + 5.0 * k);
    n.push_back(curve.at(nm.back()));
  }
  return tabulated_index(std::move(nm), std::move(n));
}

} // namespace abbe
