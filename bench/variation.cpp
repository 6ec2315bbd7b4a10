#include "bench/variation.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace abbe::bench {
namespace {

constexpr const char* kWords =
    "fan=N, tolerance=PIXELS, cutoff=X, bands=N, noise=X, exact, jitter=on, jitter=off, "
    "adaptive=on, adaptive=off or default";

template <class T>
T number(std::string_view word, std::string_view text, T lowest, T highest) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= lowest) ||
      !(value <= highest))
    throw std::invalid_argument(
        fmt::format("\"{}\": \"{}\" is not a number from {} to {}", word, text, lowest, highest));
  return value;
}

void apply(std::string_view word, RenderSettings& s) {
  const std::size_t equals = word.find('=');
  const std::string_view key = word.substr(0, equals);
  const std::string_view value = equals == word.npos ? "" : word.substr(equals + 1);
  if (word == "exact")
    s.exact = true;
  else if (key == "fan")
    s.max_fan = number(word, value, 1, 405);
  else if (key == "bands")
    s.bands = number(word, value, 1, 405);
  else if (key == "tolerance")
    s.tolerance_pixels = number(word, value, 0.0, 65536.0);
  else if (key == "cutoff")
    s.min_throughput = number(word, value, 0.0, 1.0);
  else if (key == "noise")
    s.noise = number(word, value, 0.0, 1.0);
  else if (key == "jitter" && (value == "on" || value == "off"))
    s.jitter = value == "on";
  else if (key == "adaptive" && (value == "on" || value == "off"))
    s.adaptive = value == "on" ? AdaptiveSampling::on : AdaptiveSampling::off;
  else if (word != "default")
    throw std::invalid_argument(fmt::format("\"{}\" is no variation: {}", word, kWords));
}

} // namespace

Variation parse_variation(std::string_view text, const RenderSettings& settings) {
  Variation variation{std::string(text), settings};
  while (true) {
    const std::size_t comma = text.find(',');
    apply(text.substr(0, comma), variation.settings);
    if (comma == text.npos) return variation;
    text.remove_prefix(comma + 1);
  }
}

} // namespace abbe::bench
