#include "core/plan.h"

#include "core/lights/emission.h"
#include "core/lights/sampled_surface.h"
#include "core/plan_bands.h"
#include "core/plan_drops.h"
#include "core/plan_extent.h"
#include "core/plan_lines.h"
#include "core/plan_samples.h"
#include "core/plan_surfaces.h"
#include "core/plan_tiles.h"
#include "spectral/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abbe {
namespace {

/// Builds the list of sources and their accumulators. At the standard's own sampling a source's
/// spectrum can be multiplied in per band, so one accumulator serves all; elsewhere the product of
/// spectrum and observer is folded per source, and equal spectra share an accumulator. So it is for
/// spectral lines, whose colour is that of their wavelength and not of their band.
class SourcePlanner {
public:
  SourcePlanner(Plan& plan) : plan_(plan) {
    per_band_ = plan.grid.count() == 81 || plan.grid.count() == 405;
    if (per_band_) add_accumulator(Curve::constant(1.0));
  }

  int add(const Curve& spectrum) {
    SourcePlan source;
    if (per_band_ && spectrum.spectral_lines().empty()) {
      const auto constant = spectrum.constant_value();
      source.factor = constant && plan_.settings.skip.constant_curves
                          ? BandTable(static_cast<float>(*constant), plan_.grid.count())
                          : BandTable(band_means(plan_.grid, spectrum));
    } else {
      const auto known = std::find(spectra_.begin(), spectra_.end(), spectrum);
      source.accumulator = static_cast<int>(known - spectra_.begin());
      if (known == spectra_.end()) add_accumulator(spectrum);
      source.factor = BandTable(1.0f, plan_.grid.count());
    }
    plan_.sources.push_back(std::move(source));
    return static_cast<int>(plan_.sources.size()) - 1;
  }

private:
  void add_accumulator(const Curve& spectrum) {
    spectra_.push_back(spectrum);
    AccumulatorPlan accumulator;
    for (auto* axis : {&accumulator.x, &accumulator.y, &accumulator.z})
      axis->resize(plan_.stride);
    const auto weights = band_weights(plan_.grid, spectrum, plan_.settings.observer);
    for (std::size_t b = 0; b < weights.size(); ++b) {
      accumulator.x[b] = static_cast<float>(weights[b].x);
      accumulator.y[b] = static_cast<float>(weights[b].y);
      accumulator.z[b] = static_cast<float>(weights[b].z);
    }
    accumulator.radiance = BandTable(band_means(plan_.grid, spectrum));
    plan_.accumulators.push_back(std::move(accumulator));
  }

  Plan& plan_;
  bool per_band_;
  std::vector<Curve> spectra_;
};

/// Where curves of materials are read: the bands' centres, or their lines.
std::vector<double> table_wavelengths(const Plan& plan) {
  std::vector<double> nm;
  for (int b = 0; b < plan.grid.count(); ++b)
    nm.push_back(plan.wavelength_nm(b, 0.5));
  return nm;
}

/// Paths follow what either part does. Light that it gives off is met by chance only.
MaterialPlan planned_mixture(const Plan& plan, const Mixture& mixture) {
  const MaterialPlan &a = plan.materials[mixture.first.index()],
                     &b = plan.materials[mixture.second.index()];
  MaterialPlan m;
  m.reflects = a.reflects || b.reflects;
  m.transmits = a.transmits || b.transmits;
  m.lit = a.lit || b.lit;
  m.mixture = {mixture.first.value, mixture.second.value, mixture.share};
  return m;
}

bool is_clear(const Material& material) {
  const auto absent = [](const Curve& part) { return part.constant_value() == 0.0; };
  return material.transparency.constant_value() == 1.0 && absent(material.reflectivity) &&
         absent(material.ambient) && absent(material.diffuse) && absent(material.specular) &&
         absent(material.emission) && material.roughness == 0.0 && !material.film &&
         !material.coat && !material.texture && !material.mixture;
}

void plan_materials(const Scene& scene, Plan& plan, SourcePlanner& sources) {
  const RenderSettings& settings = plan.settings;
  const std::vector<double> nm = table_wavelengths(plan);
  const auto table = [&](const Curve& curve) {
    return BandTable::at_wavelengths(nm, curve, settings.skip.constant_curves);
  };
  const auto largest = [&](const BandTable& t) {
    float most = 0.0f;
    for (int b = 0; b < plan.grid.count(); ++b)
      most = std::max(most, t[b]);
    return most;
  };
  for (const Material& material : scene.materials) {
    MaterialPlan m;
    m.ambient = table(material.ambient);
    m.diffuse = table(material.diffuse);
    m.specular = table(material.specular);
    m.reflectivity = table(material.reflectivity);
    m.transparency = table(material.transparency);
    m.specular_exponent = static_cast<float>(material.specular_exponent);
    m.fresnel = material.fresnel;
    m.conductor = material.metal.has_value();
    if (m.conductor) {
      m.metal_n = table(material.metal->n);
      m.metal_k = table(material.metal->k);
    }
    plan_surface(material, m, plan);
    m.dielectric = !m.transparency.zero();
    m.reflects = largest(m.reflectivity) > static_cast<float>(settings.min_reflectivity);
    m.transmits = largest(m.transparency) > static_cast<float>(settings.min_transparency);
    m.lit = !m.diffuse.zero() || !m.specular.zero();
    if (material.texture) {
      m.texture = plan_texture(plan.textures, *material.texture, scene.images, nm,
                               settings.skip.constant_curves);
      m.lit = true;
    }
    m.emits_behind = material.emits_behind;
    m.clear = is_clear(material);
    if (material.emission.constant_value() != 0.0)
      m.emission_source = sources.add(material.emission);
    if (material.mixture) m = planned_mixture(plan, *material.mixture);
    plan.materials.push_back(std::move(m));
  }
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

/// Which lamps light paths begin at, if any.
void plan_caustics(const Scene& scene, Plan& plan) {
  const RenderSettings& settings = plan.settings;
  if (settings.integrator != Integrator::path || settings.caustics == Caustics::off) return;
  const std::size_t specular = specular_targets(scene, plan).size();
  if (specular == 0) {
    plan.notes.push_back("nothing mirrors or refracts: no light-side passes");
    return;
  }
  for (const Light& light : scene.lights) {
    if (!endless_flux(light)) continue;
    if (settings.caustics == Caustics::on)
      throw std::invalid_argument(fmt::format(
          "the light {} has no flux that could be followed: it does not fall off with distance. "
          "Give it falloff square, or leave caustics on out",
          light.name.empty() ? "of a colour" : light.name));
    plan.notes.push_back(fmt::format("the light {} does not fall off with distance, so it has no "
                                     "flux: no caustics of it",
                                     light.name.empty() ? "of a colour" : light.name));
  }
  const std::size_t emitters = Emission(scene, plan).emitters().size();
  plan.caustics = emitters > 0;
  // Light that comes through glass is counted where it is bent to.
  if (plan.caustics && plan.settings.shadows == ShadowRule::attenuated)
    plan.settings.shadows = ShadowRule::opaque;
  plan.notes.push_back(emitters > 0
                           ? fmt::format("light-side passes: {} of the lamps shine on things that "
                                         "mirror or refract",
                                         emitters)
                           : "no lamp shines on anything that mirrors or refracts: no light-side "
                             "passes");
}

/// Paths find light that is not aimed at too, but with more noise.
void note_lamps_met_by_chance(const Scene& scene, Plan& plan) {
  if (plan.settings.integrator != Integrator::path) return;
  const auto count =
      std::count_if(scene.shapes.begin(), scene.shapes.end(), [&](const PlacedShape& placed) {
        return placed.material.valid() && !can_sample_surface(placed.shape) &&
               plan.materials[placed.material.index()].emission_source >= 0;
      });
  if (count > 0)
    plan.notes.push_back(
        fmt::format("{} {} by chance alone, since only squares, discs, spheres, "
                    "boxes and meshes can be aimed at",
                    count, count == 1 ? "shining shape is met" : "shining shapes are met"));
}

void note_content(const Scene& scene, Plan& plan) {
  const auto count = [](std::size_t n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
  };
  const auto glasses = static_cast<std::size_t>(
      std::count_if(plan.media.begin(), plan.media.end(),
                    [](const MediumPlan& m) { return !m.index.achromatic(); }));
  plan.notes.insert(plan.notes.begin(),
                    fmt::format("{}, {}, {} ({} dispersive)",
                                count(scene.shapes.size(), "shape", "shapes"),
                                count(scene.lights.size(), "lamp", "lamps"),
                                count(scene.media.size(), "medium", "media"), glasses));
  const RenderSettings& settings = plan.settings;
  plan.notes.insert(
      plan.notes.begin(),
      fmt::format("{} x {} pixels in {}, {}; {} of {:.3g} nm", plan.window.width(),
                  plan.window.height(), count(plan.tiles.size(), "tile", "tiles"),
                  (settings.may_end_early() ? "at most " : "") +
                      count(static_cast<std::size_t>(settings.samples_per_pixel), "sample a pixel",
                            "samples a pixel") +
                      (settings.adaptive == AdaptiveSampling::on ? " in the mean" : ""),
                  count(static_cast<std::size_t>(settings.bands), "band", "bands"),
                  plan.grid.width_nm()));
  if (settings.noise > 0.0)
    plan.notes.push_back(
        fmt::format("each tile ends at an estimated relative error of {}", settings.noise));
  if (scene.environment)
    plan.notes.push_back(fmt::format("the environment is a picture of {} x {} pixels{}",
                                     scene.environment->width, scene.environment->height,
                                     plan.environment ? "" : ", all black"));
  note_lamps_met_by_chance(scene, plan);
  for (const Medium& medium : scene.media)
    if (!is_achromatic(medium.index))
      plan.notes.push_back(
          fmt::format("{}: n_d {:.5f}, V_d {:.2f}", medium.name.empty() ? "a medium" : medium.name,
                      refractive_index(medium.index, kLineD_nm), abbe_number(medium.index)));
  for (const Medium& medium : scene.media)
    if (medium.drops) plan.notes.push_back(note_of(*medium.drops));
  const bool refracts = std::any_of(plan.materials.begin(), plan.materials.end(),
                                    [](const MaterialPlan& m) { return m.transmits; });
  if (!refracts)
    plan.notes.push_back("nothing refracts: no Fresnel, no fans");
  else if (glasses == 0)
    plan.notes.push_back("no medium disperses: bands never part, no fans");
  const auto empty = static_cast<std::size_t>(
      std::count_if(plan.tiles.begin(), plan.tiles.end(), [](const Tile& t) { return t.empty; }));
  if (empty > 0)
    plan.notes.push_back(fmt::format("{} of {} show the background alone: no rays there", empty,
                                     count(plan.tiles.size(), "tile", "tiles")));
}

} // namespace

double Plan::wavelength_nm(int band, double offset) const {
  if (!lines.empty())
    if (const auto& own = lines[static_cast<std::size_t>(band)]; !own.empty())
      return line_wavelength_nm(own, offset);
  return grid.wavelength_nm(band, offset);
}

Plan make_plan(const Scene& scene, const RenderSettings& settings) {
  Plan plan;
  plan.settings = settings;
  if (settings.shadows == ShadowRule::automatic)
    plan.settings.shadows =
        settings.integrator == Integrator::path ? ShadowRule::opaque : ShadowRule::attenuated;
  plan_samples(plan.settings);
  plan.grid = BandGrid(settings.bands);
  plan.stride = padded_band_count(settings.bands);

  plan.lines = lines_of_bands(scene, plan.grid);
  SourcePlanner sources(plan);
  sources.add(scene.background);
  sources.add(scene.global_ambient);
  for (const Light& light : scene.lights)
    sources.add(light.spectrum);
  plan_materials(scene, plan, sources);
  if (scene.environment) {
    plan.environment = EnvironmentMap::make(*scene.environment, table_wavelengths(plan));
    if (plan.environment) plan.environment_source = sources.add(scene.environment->light);
  }
  plan_media(scene, plan);
  plan_bands(plan);

  const PixelWindow full{0, 0, settings.width, settings.height};
  plan.window = settings.crop.value_or(full);
  if (plan.window.x0 < 0 || plan.window.y0 < 0 || plan.window.x1 > full.x1 ||
      plan.window.y1 > full.y1 || plan.window.width() <= 0 || plan.window.height() <= 0)
    throw std::invalid_argument(
        fmt::format("the crop {},{},{},{} is not a part of the {} x {} image", plan.window.x0,
                    plan.window.y0, plan.window.x1, plan.window.y1, full.x1, full.y1));
  plan.tiles = make_tiles(scene, plan.window, settings);
  plan_albedos(plan);
  plan_caustics(scene, plan);
  plan.disperses = !plan.layers.empty() ||
                   std::any_of(plan.media.begin(), plan.media.end(), [](const MediumPlan& m) {
                     return m.drops || !m.index.achromatic();
                   });
  plan.quantum = film_quantum(scene, plan.grid, settings.observer);
  note_content(scene, plan);
  note_surfaces(plan);
  return plan;
}

} // namespace abbe
