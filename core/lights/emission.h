#pragma once

#include "core/emitters/sampled_surface.h"
#include "core/lights/emission_goals.h"
#include "core/plan/plan.h"
#include "core/sampling/sampler.h"
#include "geometry/world/world.h"

#include <optional>
#include <variant>
#include <vector>

namespace abbe {

/// The beginning of a light path.
struct EmittedRay {
  RayState state;
  int source = 0;           ///< index into Plan::sources
  double flux = 0.0;        ///< per unit of the source's spectrum, over the pdf of the ray
  bool environment = false; ///< the image's colour of the ray's direction counts too
};

/// A light that light paths begin at, and where it sends them: only into directions that hold
/// something specular.
class EmittingLight {
public:
  [[nodiscard]] int source() const { return source_; }
  /// A ray of the light. Nothing where it sends no light.
  [[nodiscard]] std::optional<EmittedRay> sample(const Sampler& sampler) const;

private:
  friend class Emission;
  struct EmittingShape {
    ShapeId shape;
    SampledSurface surface;
    bool one_sided = true;
  };
  /// The bright light of an environment, which comes as that of many suns.
  struct BrightSky {
    const EnvironmentMap* map;
  };
  using Origin = std::variant<const Light*, EmittingShape, BrightSky>;

  [[nodiscard]] std::optional<EmittedRay> from(const Light* light, const Sampler& sampler) const;
  [[nodiscard]] std::optional<EmittedRay> from(const EmittingShape& emitting,
                                               const Sampler& sampler) const;
  [[nodiscard]] std::optional<EmittedRay> from(const BrightSky& sky, const Sampler& sampler) const;
  [[nodiscard]] bool stands_alone(const Light* light) const;
  [[nodiscard]] bool stands_alone(const EmittingShape& emitting) const;
  [[nodiscard]] bool stands_alone(const BrightSky&) const { return true; }

  Origin origin_;
  int source_ = 0;
  EmissionGoals goals_;
  double flux_ = 0.0; ///< mean over the bands
  const World* world_ = nullptr;
  /// Other surfaces, and solids around the light, are looked for where each path begins.
  bool looks_about_ = true;
};

/// All lights with something specular in their light.
class Emission {
public:
  /// No lights.
  Emission() = default;
  /// Keeps references to the scene.
  Emission(const Scene& scene, const Plan& plan);
  /// Finds out what lies about each light, before rays are asked for. Keeps a reference.
  void place(const World& world);

  [[nodiscard]] const std::vector<EmittingLight>& lights() const { return lights_; }
  /// True when light paths begin at this shape.
  [[nodiscard]] bool emits(ShapeId shape) const;
  /// True when light paths begin in the bright part of the environment.
  [[nodiscard]] bool sky_emits() const { return sky_emits_; }

  /// Everything that mirrors or refracts.
  [[nodiscard]] const std::vector<EmissionTarget>& targets() const { return goals_.targets; }

  /// How many of `paths` begin at each light: in proportion to flux, at least one each.
  [[nodiscard]] std::vector<std::uint32_t> shares(std::uint32_t paths) const;

private:
  void add_lights(const Scene& scene, const Plan& plan);
  void add_shapes(const Scene& scene, const Plan& plan);
  void add_sky(const Scene& scene, const Plan& plan);

  EmissionGoals goals_;
  std::vector<EmittingLight> lights_;
  std::vector<bool> shape_emits_; ///< by ShapeId
  bool sky_emits_ = false;
};

} // namespace abbe
