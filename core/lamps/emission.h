#pragma once

#include "core/emitters/sampled_surface.h"
#include "core/lamps/emission_targets.h"
#include "core/plan/plan.h"
#include "core/sampling/sampler.h"
#include "geometry/world.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

/// The beginning of a light path.
struct EmittedRay {
  RayState state;
  int source = 0;    ///< index into Plan::sources
  double flux = 0.0; ///< per unit of the source's spectrum, over the density of the ray
};

/// A lamp that light paths begin at, and where it sends them: only into directions that hold
/// something specular.
class Emitter {
public:
  [[nodiscard]] int source() const { return source_; }
  /// A ray of the lamp. Nothing where it sends no light.
  [[nodiscard]] std::optional<EmittedRay> sample(const Sampler& sampler) const;

private:
  friend class Emission;
  [[nodiscard]] std::optional<EmittedRay> from_point(const dvec3& position,
                                                     const Sampler& sampler) const;
  [[nodiscard]] std::optional<EmittedRay> from_spot(const SpotLight& spot,
                                                    const Sampler& sampler) const;
  [[nodiscard]] std::optional<EmittedRay> from_sun(const SunLight& sun,
                                                   const Sampler& sampler) const;
  [[nodiscard]] std::optional<EmittedRay> from_afar(const dvec3& direction,
                                                    const Sampler& sampler) const;
  [[nodiscard]] std::optional<EmittedRay> from_shape(const Sampler& sampler) const;
  [[nodiscard]] SurfacePoint surface_point(const dvec2& u) const;

  const Scene* scene_ = nullptr;
  int light_ = -1; ///< index into Scene::lights; negative: a shape
  ShapeId shape_;
  std::optional<SampledSurface> surface_; ///< of the shape
  bool one_sided_ = true;
  int source_ = 0;
  double flux_ = 0.0; ///< mean over the bands
  std::vector<EmissionTarget> targets_;
  std::shared_ptr<const ParallelTargets> parallel_; ///< of parallel light
  Nesting nesting_;                                 ///< solids around the lamp
};

/// All lamps with something specular in their light.
class Emission {
public:
  /// No lamps.
  Emission() = default;
  /// Keeps a reference to the scene.
  Emission(const Scene& scene, const Plan& plan);
  /// Finds the solids around each lamp, before rays are asked for.
  void place(const World& world);

  [[nodiscard]] const std::vector<Emitter>& emitters() const { return emitters_; }
  /// True when light paths begin at this shape.
  [[nodiscard]] bool emits(ShapeId shape) const;

  /// Everything that mirrors or refracts.
  [[nodiscard]] const std::vector<EmissionTarget>& targets() const { return targets_; }

  /// How many of `paths` begin at each emitter: in proportion to flux, at least one each.
  [[nodiscard]] std::vector<std::uint32_t> shares(std::uint32_t paths) const;

private:
  std::vector<EmissionTarget> targets_;
  std::vector<Emitter> emitters_;
  std::vector<bool> shape_emits_; ///< by ShapeId
};

/// True for a lamp at a place whose light does not fall off with distance: it has no flux.
[[nodiscard]] bool endless_flux(const Light& light);

} // namespace abbe
