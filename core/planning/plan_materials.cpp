#include "core/planning/plan_materials.h"

#include "core/planning/plan_drops.h"
#include "core/planning/plan_surfaces.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace abbe {
namespace {

/// Light that a mixture gives off is met by chance only.
MaterialPlan planned_mixture(const Plan& plan, const Mixture& mixture) {
  const MaterialPlan &a = plan.materials[mixture.first.index()],
                     &b = plan.materials[mixture.second.index()];
  MaterialPlan m;
  m.mixture = {mixture.first.value, mixture.second.value, mixture.share,
               either(a.facts(), b.facts()), a.lit() || b.lit()};
  return m;
}

/// A mixture of `with` and `without`, which are to stand from `place` on among the materials. As
/// both give off the same light, so does the mixture.
MaterialPlan mixture_at(std::size_t place, double chance, const MaterialPlan& with,
                        const MaterialPlan& without) {
  MaterialPlan m;
  m.emission_source = with.emission_source;
  m.emits_behind = with.emits_behind;
  const int first = static_cast<int>(place);
  m.mixture = {first, first + 1, chance, either(with.facts(), without.facts()), with.lit()};
  return m;
}

bool is_clear(const Material& material) {
  return material.transparency.constant_value() == 1.0 && material.reflectivity.zero() &&
         material.ambient.zero() && material.diffuse.zero() && material.specular.zero() &&
         material.emission.zero() && material.roughness == 0.0 && !material.film &&
         !material.coat && !material.texture && !material.mixture && !material.pane;
}

} // namespace

std::vector<double> table_wavelengths(const Plan& plan) {
  std::vector<double> nm;
  for (int b = 0; b < plan.grid.count(); ++b)
    nm.push_back(plan.wavelength_nm(b, 0.5));
  return nm;
}

void plan_materials(const Scene& scene, Plan& plan, SourcePlanner& sources) {
  const RenderSettings& settings = plan.settings;
  const CurveTables tables(table_wavelengths(plan), settings.skip.constant_curves);
  std::vector<MaterialPlan> parts; ///< of those that are met with and without what is faint
  for (const Material& material : scene.materials) {
    MaterialPlan m;
    m.ambient = tables.of(material.ambient);
    m.diffuse = tables.of(material.diffuse);
    m.phong = {tables.of(material.specular), static_cast<float>(material.specular_exponent)};
    const auto faint = faint_parts(material, tables, plan);
    m.bsdf = plan_bsdf(material, faint ? faint->with : PartFactors{}, tables, plan);
    if (material.texture)
      m.texture = plan_texture(plan.textures, *material.texture, scene.images,
                               tables.wavelengths_nm(), settings.skip.constant_curves);
    m.emits_behind = material.emits_behind;
    m.clear = is_clear(material);
    if (!material.emission.zero()) m.emission_source = sources.add(material.emission);
    if (material.mixture) m = planned_mixture(plan, *material.mixture);
    if (faint) {
      MaterialPlan without = m;
      without.bsdf = plan_bsdf(material, faint->without, tables, plan);
      const std::size_t place = scene.materials.size() + parts.size();
      parts.push_back(std::exchange(m, mixture_at(place, faint->chance, m, without)));
      parts.push_back(std::move(without));
    }
    plan.has_panes = plan.has_panes || m.facts().passes;
    plan.materials.push_back(std::move(m));
  }
  std::ranges::move(parts, std::back_inserter(plan.materials));
}

void plan_media(const Scene& scene, Plan& plan) {
  plan.vacuum.absorption_per_unit = BandTable(0.0f, plan.grid.count());
  for (const Medium& medium : scene.media) {
    MediumPlan m;
    m.index = IndexTable(medium.index, plan.settings.skip.constant_indices);
    m.absorption_per_unit = BandTable::at_wavelengths(
        table_wavelengths(plan), medium.absorption_per_mm.scaled(scene.mm_per_unit),
        plan.settings.skip.constant_curves);
    if (medium.drops && medium.drops->extinction_per_mm > 0.0) {
      m.drops = plan_drops(scene, plan, *medium.drops);
      m.absorption_per_unit = m.absorption_per_unit.plus(
          static_cast<float>(m.drops->extinction_per_unit), plan.grid.count());
      plan.has_drops = true;
    }
    m.absorbs = !m.absorption_per_unit.zero();
    plan.media.push_back(std::move(m));
  }
}

} // namespace abbe
