#include "spectral/transfer.h"

#include "spectral/data_table.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace abbe {
namespace {

constexpr double kLeastGamma = 0.1, kLargestGamma = 10.0;

// Standards give the inverse, V(L), with its knee in L; knees here are in V.
const std::array<TransferFunction, 5>& named_functions() {
  static const std::array<TransferFunction, 5> list{{
      {"linear", 1.0, 1.0, 0.0, 0.0, 0.0},
      // V = 12.92 L, then 1.055 L^(1/2.4) - 0.055. [IEC99]
      {"srgb", 2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045},
      // V = 4.5 L for L < 0.018, then 1.099 L^0.45 - 0.099. [BT709, BT2020]
      {"rec709", 1.0 / 0.45, 1.0 / 1.099, 0.099 / 1.099, 1.0 / 4.5, 4.5 * 0.018},
      // V = 4 L for L < 0.0228, then 1.1115 L^0.45 - 0.1115. [ST240]
      {"smpte240m", 1.0 / 0.45, 1.0 / 1.1115, 0.1115 / 1.1115, 1.0 / 4.0, 4.0 * 0.0228},
      // V = 16 L for L < 1/512, then L^(1/1.8). [ROMM]
      {"romm", 1.8, 1.0, 0.0, 1.0 / 16.0, 16.0 / 512.0},
  }};
  return list;
}

const TransferFunction& named(std::string_view name) {
  for (const TransferFunction& function : named_functions())
    if (function.name == name) return function;
  throw std::out_of_range("no such transfer function");
}

} // namespace

const TransferFunction& srgb_transfer() {
  static const TransferFunction& function = named("srgb");
  return function;
}

const TransferFunction& linear_transfer() {
  static const TransferFunction& function = named("linear");
  return function;
}

TransferFunction power_transfer(double gamma) {
  if (!std::isfinite(gamma) || gamma < kLeastGamma || gamma > kLargestGamma)
    throw std::invalid_argument("a gamma is a number from 0.1 to 10");
  TransferFunction function;
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), gamma);
  function.name.assign(text.data(), written.ptr);
  function.exponent = gamma;
  return function;
}

std::optional<TransferFunction> find_transfer(std::string_view name) {
  for (const TransferFunction& function : named_functions())
    if (same_name(function.name, name)) return function;
  if (same_name(name, "rec2020")) return named("rec709"); // the same curve [BT2020]
  double gamma = 0.0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), gamma);
  if (error != std::errc() || end != name.data() + name.size() || !std::isfinite(gamma) ||
      gamma < kLeastGamma || gamma > kLargestGamma)
    return std::nullopt;
  return power_transfer(gamma);
}

std::vector<std::string> transfer_names() {
  std::vector<std::string> names{"rec2020"};
  for (const TransferFunction& function : named_functions())
    names.push_back(function.name);
  return names;
}

double encode(const TransferFunction& t, double linear) {
  const double magnitude = std::abs(linear);
  const double code = magnitude < t.knee * t.slope
                          ? magnitude / t.slope
                          : (std::pow(magnitude, 1.0 / t.exponent) - t.offset) / t.scale;
  return std::copysign(code, linear);
}

double decode(const TransferFunction& t, double code) {
  const double magnitude = std::abs(code);
  const double linear = magnitude < t.knee ? magnitude * t.slope
                                           : std::pow(t.scale * magnitude + t.offset, t.exponent);
  return std::copysign(linear, code);
}

} // namespace abbe
