#include "io/building/setting_effects.h"

#include "core/lights/light_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <variant>

namespace abbe {
namespace {

/// What the effect of a keyword may hang on.
struct Rest {
  const Scene& scene;
  const RenderSettings& settings;
  const GivenKeywords& given;

  [[nodiscard]] bool has(std::string_view keyword) const {
    return std::ranges::find(given, keyword, &GivenKeyword::keyword) != given.end();
  }
};

struct SettingEffect {
  std::string_view keyword, option; ///< empty: none
  bool (*acts)(const Rest&);
  std::string_view why_not;
};

bool follows_paths(const Rest& rest) {
  return rest.settings.integrator == Integrator::path;
}
bool follows_light(const Rest& rest) {
  return follows_paths(rest) && rest.settings.caustics != Caustics::off;
}
bool shares_rays(const Rest& rest) {
  return !rest.settings.exact;
}
/// Stands in the list of keywords for a light; no keyword has spaces.
constexpr std::string_view kEndlessLight = "light without falloff";
constexpr std::string_view kNoLightPaths =
    "light paths are followed by the integrator path only, and unless caustics is off";
constexpr std::string_view kExact = "with exact, no two bands share a ray";

constexpr auto kEffects = std::to_array<SettingEffect>({
    {"caustics", "--caustics", follows_paths,
     "light paths are followed by the integrator path only"},
    {"lightPaths", "--light-paths", follows_light, kNoLightPaths},
    {"photonRadius", "--photon-radius", follows_light, kNoLightPaths},
    {"brightSky", "--bright-sky",
     [](const Rest& rest) { return follows_light(rest) && rest.scene.environment.has_value(); },
     "it says which light of an environment is followed by light paths, with the integrator path"},
    {"tolerance", "--tolerance", shares_rays, kExact},
    {"maxFan", "--fan", shares_rays, kExact},
    {"globalAmbient", "", [](const Rest& rest) { return !follows_paths(rest); },
     "the integrator path takes no ambient light"},
    {"focusDistance", "",
     [](const Rest& rest) {
       return !std::holds_alternative<Pinhole>(rest.scene.camera.kind) || rest.has("filmHeight");
     },
     "the camera is a pinhole, through which all is sharp: it needs an aperture or fNumber"},
    {"fieldOfView", "", [](const Rest& rest) { return !rest.has("filmHeight"); },
     "filmHeight replaces it"},
    // Noted for others that ask for them.
    {"filmHeight", "", [](const Rest&) { return true; }, ""},
    {"minReflectivity", "", [](const Rest&) { return true; }, ""},
    {"minTransparency", "", [](const Rest&) { return true; }, ""},
});

} // namespace

void note_given(GivenKeywords& given, std::string_view keyword, const SourcePosition& where) {
  if (std::ranges::find(kEffects, keyword, &SettingEffect::keyword) == kEffects.end()) return;
  const auto known = std::ranges::find(given, keyword, &GivenKeyword::keyword);
  if (known == given.end())
    given.push_back({keyword, where});
  else
    known->where = where;
}

void note_light(GivenKeywords& given, const Light& light, const SourcePosition& where) {
  if (!endless_flux(light)) return;
  if (std::ranges::find(given, kEndlessLight, &GivenKeyword::keyword) != given.end()) return;
  given.push_back({kEndlessLight, where});
}

void check_caustics(const GivenKeywords& given, const RenderSettings& settings) {
  if (settings.integrator != Integrator::path || settings.caustics != Caustics::on) return;
  const auto light = std::ranges::find(given, kEndlessLight, &GivenKeyword::keyword);
  if (light == given.end()) return;
  throw ReadError(light->where, "this light has no flux that could be followed for caustics",
                  "it does not fall off with distance, and caustics is on",
                  "Give it falloff square, or leave caustics on out");
}

void warn_of_settings(const Scene& scene, const GivenKeywords& given,
                      const SettingsOverride& options, const Warn& warn) {
  const RenderSettings settings = overridden(scene.settings, options);
  const Rest as_read{scene, scene.settings, given}, in_the_end{scene, settings, given};
  for (const SettingEffect& effect : kEffects) {
    if (effect.acts(in_the_end)) continue;
    for (const auto& option : options)
      if (!effect.option.empty() && option.row->option == effect.option)
        warn(fmt::format("{} has no effect ({})", effect.option, effect.why_not));
    if (effect.acts(as_read)) continue;
    for (const GivenKeyword& keyword : given)
      if (keyword.keyword == effect.keyword)
        warn(fmt::format("{}: {} has no effect ({})", to_string(keyword.where), keyword.keyword,
                         effect.why_not));
  }
}

} // namespace abbe
