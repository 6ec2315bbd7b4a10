#include "io/building/faint_parts.h"

#include "spectral/band_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace abbe {
namespace {

/// A setting below which a part of a material is left out.
struct LeastPart {
  std::string_view keyword, option;
  double RenderSettings::* least;
  Curve Material::* part;
  std::string_view verb, what;
};

constexpr std::array<LeastPart, 2> kLeastParts{{
    {"minReflectivity", "--min-reflectivity", &RenderSettings::min_reflectivity,
     &Material::reflectivity, "reflect", "reflections"},
    {"minTransparency", "--min-transparency", &RenderSettings::min_transparency,
     &Material::transparency, "let through", "refractions"},
}};

double most_of(const Curve& curve) {
  double most = 0.0;
  for (double nm = kLowerNm; nm <= kUpperNm; nm += kSampleStepNm)
    most = std::max(most, curve.at(nm));
  return most;
}

/// The option or the place of the keyword that the setting comes from.
std::string origin_of(const LeastPart& row, const GivenKeywords& given,
                      const SettingsOverride& options) {
  for (const auto& option : options)
    if (option.row->option == row.option) return std::string(row.option);
  for (const GivenKeyword& keyword : given)
    if (keyword.keyword == row.keyword)
      return fmt::format("{}: {}", to_string(keyword.where), row.keyword);
  return std::string(row.keyword);
}

} // namespace

void warn_of_faint_parts(const Scene& scene, const GivenKeywords& given,
                         const SettingsOverride& options, const Warn& warn) {
  const RenderSettings settings = overridden(scene.settings, options);
  for (const LeastPart& row : kLeastParts) {
    const double least = settings.*row.least;
    if (least <= 0.0) continue;
    int count = 0;
    double most = 0.0;
    for (const Material& material : scene.materials) {
      const double part = most_of(material.*row.part);
      if (!(part > 0.0) || part > least) continue;
      ++count;
      most = std::max(most, part);
    }
    if (count == 0) continue;
    warn(fmt::format("{} {:g} takes light from the picture: {} of its materials {} at most {:.3g}, "
                     "and their {} are left out",
                     origin_of(row, given, options), least, count, row.verb, most, row.what));
  }
}

} // namespace abbe
