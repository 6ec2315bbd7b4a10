#include "core/planning/plan_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

FilmLayer plan_film(const Material& material, Plan& plan) {
  if (!material.film) return {};
  const int layer = add_layer(material.film->index, plan);
  return {material.fresnel ? material.film->thickness_nm : 0.0, layer};
}

float most_of(const BandTable& table, int bands) {
  float most = 0.0f;
  for (int b = 0; b < bands; ++b)
    most = std::max(most, table[b]);
  return most;
}

Curve times(const Curve& curve, double factor) {
  return factor == 0.0 ? Curve() : curve.scaled(factor);
}

} // namespace

BandTable CurveTables::of(const Curve& curve) const {
  return BandTable::at_wavelengths(nm_, curve, keep_constant_);
}

std::optional<FaintParts> faint_parts(const Material& material, const CurveTables& tables,
                                      const Plan& plan) {
  if (material.coat || material.mixture) return std::nullopt;
  FaintParts faint;
  const auto ask = [&](const Curve& part, double least, bool& is_faint) {
    if (least <= 0.0) return;
    const float most = most_of(tables.of(part), plan.grid.count());
    if (most <= 0.0f || most >= static_cast<float>(least)) return;
    is_faint = true;
    faint.chance = std::max(faint.chance, static_cast<double>(most) / least);
  };
  bool reflectivity = false, transparency = false;
  ask(material.reflectivity, plan.settings.min_reflectivity, reflectivity);
  ask(material.transparency, plan.settings.min_transparency, transparency);
  if (!reflectivity && !transparency) return std::nullopt;
  const double brighter = 1.0 / faint.chance;
  faint.without = {reflectivity ? 0.0 : 1.0, transparency ? 0.0 : 1.0};
  faint.with = {reflectivity ? brighter : 1.0, transparency ? brighter : 1.0};
  return faint;
}

Bsdf plan_bsdf(const Material& material, const PartFactors& factors, const CurveTables& tables,
               Plan& plan) {
  const BandTable reflectivity = tables.of(times(material.reflectivity, factors.reflectivity));
  const BandTable transparency = tables.of(times(material.transparency, factors.transparency));
  if (material.pane) {
    const ThinPane& pane = *material.pane;
    return ThinGlass{add_layer(pane.index, plan),
                     tables.of(pane.absorption_per_mm.scaled(pane.thickness_mm)), reflectivity,
                     transparency};
  }
  // A film that Fresnel's equations do not see is none, but remains a layer of the plan.
  const FilmLayer film = plan_film(material, plan);
  const double roughness = material.roughness < kSmoothest ? 0.0 : material.roughness;
  if (material.coat) return CoatedDiffuse{add_layer(*material.coat, plan), roughness, std::nullopt};

  if (!tables.of(material.transparency).zero()) { // glass, even where its refraction is left out
    if (reflectivity.zero() && transparency.zero()) return Diffuse{};
    Dielectric smooth{reflectivity, transparency, material.fresnel, film};
    if (roughness == 0.0) return smooth;
    return RoughDielectric{std::move(smooth), roughness, material.compensation, std::nullopt};
  }
  if (reflectivity.zero()) return Diffuse{};
  if (material.metal && material.fresnel) {
    Conductor smooth{reflectivity, tables.of(material.metal->n), tables.of(material.metal->k),
                     film};
    if (roughness == 0.0) return smooth;
    return RoughConductor{std::move(smooth), roughness, material.compensation, std::nullopt};
  }
  Mirror smooth{reflectivity};
  if (roughness == 0.0) return smooth;
  return RoughConductor{std::move(smooth), roughness, material.compensation, std::nullopt};
}

void plan_albedos(Plan& plan) {
  if (plan.settings.integrator != Integrator::path) return;
  const double eta_max = largest_ratio(plan);
  for (MaterialPlan& material : plan.materials)
    std::visit(
        [&](auto& bsdf) {
          if constexpr (requires { bsdf.find_albedo(eta_max); }) bsdf.find_albedo(eta_max);
        },
        material.bsdf);
}

void note_surfaces(Plan& plan) {
  if (plan.settings.integrator != Integrator::whitted) return;
  const auto rough = std::count_if(plan.materials.begin(), plan.materials.end(),
                                   [](const MaterialPlan& m) { return m.facts().rough; });
  if (rough > 0)
    plan.notes.push_back(fmt::format("{} rough material{}: whitted shows {} smooth", rough,
                                     rough == 1 ? "" : "s", rough == 1 ? "it" : "them"));
}

} // namespace abbe
