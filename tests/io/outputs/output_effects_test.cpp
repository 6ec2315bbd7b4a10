#include "io/outputs/output_effects.h"

#include "io/program/command_line.h"
#include "tests/catch.h"

#include <string>
#include <vector>

using namespace abbe;

namespace {

std::vector<std::string> warnings_of(std::vector<const char*> words) {
  words.insert(words.begin(), {"abbe", "render", "s.sdl"});
  const auto command =
      std::get<RenderCommand>(parse_command_line(static_cast<int>(words.size()), words.data()));
  std::vector<std::string> warnings;
  warn_of_outputs(command.given, {command.outputs, command.spectral_output}, command.output,
                  [&](const std::string& message) { warnings.push_back(message); });
  return warnings;
}

} // namespace

TEST_CASE("options of images that are not written are warned of") {
  const std::vector<std::vector<const char*>> options{
      {"--exr-pixel", "half", ".exr"},  {"--exr-space", "acescg", ".exr"},
      {"--exr-tag", "none", ".exr"},    {"--profile", "v2", ".png"},
      {"--tiff-depth", "16", ".tiff"},  {"--png-depth", "16", ".png"},
      {"--display", "p3", ".png"},      {"--transfer", "2.2", ".tiff"},
      {"--gamut", "clip", ".tif"},      {"--exposure", "1", ".png"},
      {"--white-point", "D50", ".PNG"}, {"--adaptation", "cat16", ".png"},
      {"--tone", "filmic", ".tif"}};
  for (const auto& option : options) {
    const std::string right = std::string("a") + option[2];
    const char* const wrong = option[2] == std::string(".exr") ? "a.png" : "a.exr";
    INFO(option[0]);
    CHECK(warnings_of({option[0], option[1], "-o", right.c_str()}).empty());
    const auto warnings = warnings_of({option[0], option[1], "-o", wrong});
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find(std::string(option[0]) + " has no effect (") == 0);
  }
  CHECK(warnings_of({"--errors", "-o", "a.exr"}).empty());
  CHECK(warnings_of({"--errors", "-o", "a.png"}).size() == 1);
  CHECK(warnings_of({"--band-images", "-o", "a.png"}).size() == 1);
  CHECK(warnings_of({"-o", "a.png"}).empty());
}

TEST_CASE("half floats of the spectral image are warned of") {
  CHECK(warnings_of({"--exr-pixel", "half", "--spectral", "hs.exr", "-o", "a.exr"}) ==
        std::vector<std::string>{
            "--exr-pixel half has no effect on the EXR of all bands, whose pixels are float"});
  CHECK(warnings_of({"--exr-pixel", "half", "--spectral", "hs.exr", "-o", "a.png"}).size() == 1);
  CHECK(warnings_of({"--exr-pixel", "float", "--spectral", "hs.exr", "-o", "a.exr"}).empty());
  CHECK(warnings_of({"--spectral", "hs.exr", "-o", "a.exr"}).empty());
}

TEST_CASE("an adaptation to no white point is warned of") {
  const std::vector<std::string> given{"--adaptation"};
  const auto warned = [&](const char* image, const DisplaySettings& display) {
    int count = 0;
    warn_of_adaptation(given, {{image}}, display, [&](const std::string&) { ++count; });
    return count;
  };
  CHECK(warned("a.png", {}) == 1);
  CHECK(warned("a.exr", {}) == 0); // it has no effect for another reason, which is told
  DisplaySettings white;
  white.white_point = WhitePoint::at({0.3, 0.3});
  CHECK(warned("a.png", white) == 0);
}
