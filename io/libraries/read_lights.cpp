// A light library, conventionally *.filter:
//
//   filter 2a
//   {
//     intensity 0.85
//     colour 81 0.000 0.000 ... 0.000      ! 380, 385 ... 780 nm, 1 is the equal-energy spectrum
//   }
//   endfilter

#include "io/libraries/read_lights.h"

#include "core/scene/quantity_limits.h"
#include "io/libraries/read_library.h"

#include <array>
#include <span>

namespace abbe {
namespace {

constexpr LibraryWords kLightWords{"filter", "endfilter"};

constexpr std::array<LibraryKey<LightSpectrum>, 2> kLightKeys{{
    {"intensity x",
     [](LightSpectrum& light, Arguments& arguments, const Warn&) {
       light.intensity = arguments.number({"a factor on the colour", 0.0, kMostLight});
     }},
    {"colour 41|81|201|401 v380 ... v780",
     [](LightSpectrum& light, Arguments& arguments, const Warn& warn) {
       light.colour = read_samples(arguments, warn);
     },
     true},
}};

} // namespace

Curve spectrum(const LightSpectrum& light) {
  return light.colour.scaled(light.intensity);
}

std::vector<LightSpectrum> read_lights(const std::filesystem::path& file, const Warn& warn) {
  return read_lights_text(read_text_file(file), file.string(), warn);
}

std::vector<LightSpectrum> read_lights_text(std::string_view text, const std::string& file,
                                            const Warn& warn) {
  return read_library(text, file, kLightWords,
                      std::span<const LibraryKey<LightSpectrum>>(kLightKeys), warn);
}

} // namespace abbe
