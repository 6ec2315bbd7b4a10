#include "bench/variation.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <stdexcept>

namespace abbe::bench {
namespace {

constexpr const char* kWords =
    "fan=N, tolerance=PIXELS, cutoff=X, bands=N, noise=X, lightpaths=X, exact, jitter=on|off, "
    "integrator=whitted|path, caustics=on|off, adaptive=on|off or default";

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

template <class T>
struct Choice {
  std::string_view word;
  T value;
};

/// Sets `setting` when the word is one of the choices.
template <class T>
bool chosen(std::string_view word, const std::array<Choice<T>, 2>& choices, T& setting) {
  for (const Choice<T>& choice : choices)
    if (choice.word == word) {
      setting = choice.value;
      return true;
    }
  return false;
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
  else if (key == "lightpaths")
    s.light_paths = number(word, value, 0.0, 1e6);
  else if (word != "default" &&
           !chosen<bool>(word, {{{"jitter=on", true}, {"jitter=off", false}}}, s.jitter) &&
           !chosen<Integrator>(word,
                               {{{"integrator=whitted", Integrator::whitted},
                                 {"integrator=path", Integrator::path}}},
                               s.integrator) &&
           !chosen<Caustics>(word,
                             {{{"caustics=on", Caustics::on}, {"caustics=off", Caustics::off}}},
                             s.caustics) &&
           !chosen<AdaptiveSampling>(
               word,
               {{{"adaptive=on", AdaptiveSampling::on}, {"adaptive=off", AdaptiveSampling::off}}},
               s.adaptive))
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
