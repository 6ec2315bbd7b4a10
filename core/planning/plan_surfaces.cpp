#include "core/planning/plan_surfaces.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

/// Smoother surfaces are taken as smooth: their slopes of 1e-4 turn light by less than the width of
/// a pixel in a picture of 30 degrees with 2600 pixels.
constexpr double kSmoothest = 0.01;

int add_layer(const Dispersion& index, Plan& plan) {
  plan.layers.emplace_back(index);
  return static_cast<int>(plan.layers.size()) - 1;
}

/// The largest ratio of the indices of any two media or layers, in any band.
double largest_ratio(const Plan& plan) {
  double least = 1.0, most = 1.0;
  const auto include = [&](const IndexTable& index) {
    for (int b = 0; b <= plan.grid.count(); ++b) {
      const double n = index.at(plan.grid.lower_nm(b));
      least = std::min(least, n);
      most = std::max(most, n);
    }
  };
  for (const MediumPlan& medium : plan.media)
    include(medium.index);
  for (const IndexTable& layer : plan.layers)
    include(layer);
  return most / least;
}

} // namespace

void plan_surface(const Material& material, MaterialPlan& planned, Plan& plan) {
  planned.roughness = material.roughness < kSmoothest ? 0.0 : material.roughness;
  planned.compensation = material.compensation;
  if (material.film) {
    planned.film_nm = material.film->thickness_nm;
    planned.film = add_layer(material.film->index, plan);
  }
  if (material.coat) {
    planned.coat = add_layer(*material.coat, plan);
    planned.reflectivity = BandTable(1.0f, plan.grid.count());
    planned.fresnel = true;
  }
}

void plan_albedos(Plan& plan) {
  if (plan.settings.integrator != Integrator::path) return;
  const double eta_max = largest_ratio(plan);
  for (MaterialPlan& m : plan.materials) {
    if (m.roughness == 0.0 || !(m.reflects || m.transmits)) continue;
    const Ggx ggx = Ggx::from_roughness(m.roughness);
    if (m.coat >= 0 || (m.dielectric && m.compensation && eta_max > 1.0))
      m.glass_albedo.emplace(ggx, std::max(eta_max, 1.01));
    else if (!m.dielectric && m.compensation)
      m.mirror_albedo.emplace(ggx);
  }
}

void note_surfaces(Plan& plan) {
  if (plan.settings.integrator != Integrator::whitted) return;
  const auto rough = std::count_if(plan.materials.begin(), plan.materials.end(), [](const auto& m) {
    return m.roughness > 0.0 && (m.reflects || m.transmits);
  });
  if (rough > 0)
    plan.notes.push_back(fmt::format("{} rough material{}: whitted shows {} smooth", rough,
                                     rough == 1 ? "" : "s", rough == 1 ? "it" : "them"));
}

} // namespace abbe
