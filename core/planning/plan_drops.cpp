#include "core/planning/plan_drops.h"

#include "core/drops/drop_optics.h"
#include "core/lights/light_kinds.h"
#include "spectral/fraunhofer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// The wavelengths that stand for a band: so many that the secondary bow, the one that dispersion
/// moves most, moves by less than a cell from one to the next. The centre where nothing is drawn.
std::vector<double> wavelengths_of(const Plan& plan, const Dispersion& index, int band) {
  if (!plan.settings.jitter) return {plan.wavelength_nm(band, 0.5)};
  const auto bow = [&](double nm) { return bow_angle(refractive_index(index, nm), 3); };
  const auto lower = bow(plan.grid.lower_nm(band)), upper = bow(plan.grid.lower_nm(band + 1));
  const double cell = std::numbers::pi / static_cast<double>(DropPhaseFunction::kCells);
  int count = lower && upper ? static_cast<int>(std::abs(*upper - *lower) / cell) + 1 : 1;
  constexpr int kForLines = 16; // shares of a band's lines are rounded to this part
  if (!plan.lines.empty()) count = std::max(count, kForLines);
  std::vector<double> nm;
  for (int k = 0; k < count; ++k)
    nm.push_back(plan.wavelength_nm(band, (k + 0.5) / count));
  return nm;
}

} // namespace

DropsPlan plan_drops(const Scene& scene, const Plan& plan, const Drops& drops) {
  DropsPlan result;
  result.extinction_per_unit = drops.extinction_per_mm * scene.mm_per_unit;
  std::vector<std::vector<double>> nm;
  for (int b = 0; b < plan.grid.count(); ++b)
    nm.push_back(wavelengths_of(plan, drops.index, b));
  const auto distant = [](const Light& light) { return !position(light); };
  const auto parallel = [&](const Light& light) { return distant(light) && !disc(light); };
  // A sun counts as parallel light with `whitted`; `path` samples its disc.
  if (std::any_of(scene.lights.begin(), scene.lights.end(), distant))
    result.under_sun.emplace(drops.index, nm, drops.sun_radius);
  const bool glowing =
      std::any_of(plan.materials.begin(), plan.materials.end(),
                  [](const MaterialPlan& material) { return material.emission_source >= 0; });
  if (glowing || plan.environment ||
      !std::all_of(scene.lights.begin(), scene.lights.end(), parallel))
    result.near_light.emplace(drops.index, nm, 0.0);
  return result;
}

std::string note_of(const Drops& drops) {
  const double n = refractive_index(drops.index, kLineD_nm);
  std::string bows;
  for (const auto& [order, name] : {std::pair(2, "primary"), std::pair(3, "secondary")})
    if (const auto angle = bow_angle(n, order))
      bows += fmt::format("{} bow {:.1f}, ", name, 180.0 - *angle * 180.0 / std::numbers::pi);
  return fmt::format("drops: n_d {:.4f}, {}degrees from the antisolar point; rays of orders above "
                     "{} are left out, {:.2g} % of the light",
                     n, bows, DropPhaseFunction::kLastOrder,
                     100.0 * drop_remainder(n, DropPhaseFunction::kLastOrder));
}

} // namespace abbe
