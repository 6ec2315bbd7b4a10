#include "io/outputs/output_effects.h"

#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace abbe {
namespace {

bool has_image(const Outputs& outputs, std::initializer_list<std::string_view> extensions) {
  return std::ranges::any_of(outputs.images, [&](const std::filesystem::path& image) {
    return std::ranges::any_of(extensions, [&](std::string_view extension) {
      return same_name(extension, image.extension().string());
    });
  });
}
bool has_exr(const Outputs& outputs) {
  return has_image(outputs, {".exr"});
}
bool has_exr_or_spectral(const Outputs& outputs) {
  return has_exr(outputs) || outputs.spectral;
}
bool has_screen(const Outputs& outputs) {
  return has_image(outputs, {".tif", ".tiff", ".png"});
}

/// The state of a part holds what the EXR that is made of it will have.
bool has_exr_or_part(const Outputs& outputs) {
  return has_exr(outputs) || outputs.images.empty();
}

struct OutputEffect {
  std::string_view option;
  bool (*acts)(const Outputs&);
  std::string_view why_not;
};

constexpr std::string_view kForScreens = "no TIFF and no PNG is written";

constexpr auto kEffects = std::to_array<OutputEffect>({
    {"--exr-pixel", has_exr, "no EXR is written but that of all bands, whose pixels are float"},
    {"--exr-space", has_exr, "no EXR is written but that of all bands, whose space is rec709"},
    {"--exr-tag", has_exr_or_spectral, "no EXR is written"},
    {"--profile", has_screen, kForScreens},
    {"--band-images", has_exr_or_part, "only EXR holds them"},
    {"--errors", has_exr_or_part, "only EXR holds errors"},
    {"--layers", has_exr_or_part, "only EXR holds layers"},
    {"--layer-files", has_exr, "only EXR holds layers"},
    {"--tiff-depth", [](const Outputs& o) { return has_image(o, {".tif", ".tiff"}); },
     "no TIFF is written"},
    {"--png-depth", [](const Outputs& o) { return has_image(o, {".png"}); }, "no PNG is written"},
    {"--display", has_screen, kForScreens},
    {"--transfer", has_screen, kForScreens},
    {"--gamut", has_screen, kForScreens},
    {"--exposure", has_screen, kForScreens},
    {"--white-point", has_screen, kForScreens},
    {"--adaptation", has_screen, kForScreens},
    {"--tone", has_screen, kForScreens},
    {"--ocio", has_screen, kForScreens},
    {"--ocio-display", has_screen, kForScreens},
    {"--ocio-view", has_screen, kForScreens},
});

} // namespace

void warn_of_outputs(std::span<const std::string> given, const Outputs& outputs,
                     const OutputOptions& options, const Warn& warn) {
  const auto is_given = [&](std::string_view option) {
    return std::ranges::find(given, option) != given.end();
  };
  for (const OutputEffect& effect : kEffects)
    if (is_given(effect.option) && !effect.acts(outputs))
      warn(fmt::format("{} has no effect ({})", effect.option, effect.why_not));
  for (const char* option : {"--gamut", "--tone", "--white-point", "--adaptation"})
    if (options.ocio && is_given(option) && has_screen(outputs))
      warn(fmt::format("{} has no effect (--ocio makes the picture)", option));
  if (is_given("--exr-pixel") && outputs.spectral && has_exr(outputs) &&
      options.exr_pixel == ExrPixel::half)
    warn("--exr-pixel half has no effect on the EXR of all bands, whose pixels are float");
}

void warn_of_adaptation(std::span<const std::string> given, const Outputs& outputs,
                        const DisplaySettings& display, const Warn& warn) {
  const bool is_given = std::ranges::find(given, "--adaptation") != given.end();
  if (is_given && has_screen(outputs) && !display.white_point)
    warn("--adaptation has no effect without --white-point");
}

} // namespace abbe
