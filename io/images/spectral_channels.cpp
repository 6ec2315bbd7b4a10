#include "io/images/spectral_channels.h"

#include "io/text/numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace abbe {
namespace {

constexpr double kLightSpeedMPerS = 299792458.0; // in vacuum

/// The factor of a prefix of units; empty for what is none. (source: Fichet2021)
std::optional<double> factor_of(std::string_view prefix) {
  constexpr std::pair<std::string_view, double> kPrefixes[] = {
      {"", 1.0},   {"Y", 1e24}, {"Z", 1e21}, {"E", 1e18}, {"P", 1e15},  {"T", 1e12},
      {"G", 1e9},  {"M", 1e6},  {"k", 1e3},  {"h", 1e2},  {"da", 1e1},  {"d", 1e-1},
      {"c", 1e-2}, {"m", 1e-3}, {"u", 1e-6}, {"n", 1e-9}, {"p", 1e-12},
  };
  for (const auto& [name, factor] : kPrefixes)
    if (prefix == name) return factor;
  return std::nullopt;
}

/// A wavelength or frequency, as it stands after the channel's kind, in nm.
std::optional<double> wavelength_nm(std::string_view text) {
  const std::size_t end = text.find_last_of("0123456789,");
  if (end == text.npos) return std::nullopt;
  std::string number(text.substr(0, end + 1));
  std::string_view unit = text.substr(end + 1);
  if (number.find('.') != number.npos) return std::nullopt;
  std::ranges::replace(number, ',', '.');
  const std::optional<double> value = parse_finite(number);
  const bool length = unit.ends_with('m'), frequency = unit.ends_with("Hz");
  if (!value || !(*value > 0.0) || !(length || frequency)) return std::nullopt;
  const auto factor = factor_of(unit.substr(0, unit.size() - (length ? 1 : 2)));
  if (!factor) return std::nullopt;
  // Nanometres stay the number that is written.
  if (length) return unit == "nm" ? *value : *value * *factor * 1e9;
  return kLightSpeedMPerS / (*value * *factor) * 1e9;
}

std::vector<SpectralChannel> channels_of_kind(std::span<const std::string> names,
                                              std::string_view kind) {
  std::vector<SpectralChannel> found;
  for (const std::string& name : names)
    if (name.starts_with(kind))
      if (const auto nm = wavelength_nm(std::string_view(name).substr(kind.size())))
        found.push_back({name, *nm});
  std::ranges::sort(found, {}, &SpectralChannel::wavelength_nm);
  const auto same = std::ranges::unique(found, {}, &SpectralChannel::wavelength_nm);
  found.erase(same.begin(), same.end());
  return found;
}

} // namespace

std::vector<SpectralChannel> spectral_channels(std::span<const std::string> names) {
  std::vector<SpectralChannel> emitted = channels_of_kind(names, "S0.");
  return emitted.empty() ? channels_of_kind(names, "T.") : emitted;
}

} // namespace abbe
