#pragma once

#include "core/emitters/sampled_surface.h"
#include "core/film/radiance_sums.h"
#include "core/lights/light_disc.h"
#include "core/lights/light_hierarchy.h"
#include "geometry/world/world.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace abbe {

/// A direction to a light, chosen to connect a place to it.
struct LightSample {
  dvec3 direction{0.0};  ///< unit, towards the light
  double distance = 0.0; ///< infinite for parallel light
  /// The pdf, per steradian, with which the direction was chosen; 0 for lights without extent,
  /// which no ray meets by chance.
  double pdf = 0.0;
  /// Factor on the source's spectrum: radiance over pdf; for lights without extent irradiance at
  /// normal incidence over the chance of having chosen this light.
  double weight = 0.0;
  int source = 0;           ///< index into Plan::sources
  bool environment = false; ///< the image's colour of this direction counts too
  /// The shape whose surface is meant, if others may show in its place, and those.
  ShapeId may_be_hidden = {};
  std::span<const ShapeId> hiders = {};
};

/// Everything that can be aimed at to light a place: the scene's lights, shapes whose material
/// emits, and the environment. One of them is chosen by what it can send to the place.
class Lights {
public:
  /// Keeps references to both.
  Lights(const Scene& scene, const Plan& plan);
  /// Finds the shapes that others may hide; before this is done all are thought to show.
  void place(const World& world);

  [[nodiscard]] bool empty() const { return choices_.empty(); }
  /// True when no number is needed to choose one.
  [[nodiscard]] bool single() const { return choices_.size() == 1; }

  /// Chooses a light (by `choice` in [0, 1)) and a point on it (by `u`), as seen from a place.
  /// Returns nothing where the light does not shine.
  [[nodiscard]] std::optional<LightSample> sample(const dvec3& place, double choice,
                                                  const dvec2& u) const;

  /// The pdf, per steradian, with which `sample` would have chosen the direction from `place` to an
  /// emitting surface that a ray met. 0 for surfaces that are not aimed at.
  [[nodiscard]] double pdf(const dvec3& place, const Hit& hit) const;

  /// Multiplies the light of a sample per band by what is not in its weight and its source: the
  /// colour of an environment.
  void tint(const LightSample& sample, BandSpan<float> light) const {
    if (sample.environment) plan_.environment->scale(sample.direction, light);
  }

  /// True where a ray that leaves the scene along a unit direction sees the disc of a sun.
  [[nodiscard]] bool sun_shows(const dvec3& direction) const;

  /// A ray that leaves the scene, and how it came to its direction.
  struct LeavingRay {
    dvec3 place;      ///< where its direction was drawn
    dvec3 direction;  ///< unit
    double pdf = 0.0; ///< per steradian, with which it was drawn; 0: it was not
  };
  /// What of the sky a ray does not see, since its light is found otherwise.
  struct LeftOut {
    bool suns = false;
    bool bright = false; ///< the bright part of the environment
  };
  /// Adds what such a ray sees: the background, the discs of suns, and the environment, each
  /// weighed against `sample`. The ray ends there: its throughput is changed.
  void add_sky(const LeavingRay& ray, LeftOut left_out, BandSpan<float> throughput,
               RadianceSums& sums) const;

private:
  /// A light of the scene that is seen in one direction.
  struct PointOfLight {
    const Light* light;
  };
  /// A shape's surface.
  struct SurfaceLight {
    SampledSurface surface;
    bool solid; ///< it gives light off outwards only
    ShapeId shape;
    std::vector<ShapeId> hiders = {}; ///< whose surfaces may coincide with it, and show there
  };
  struct EnvironmentLight {
    const EnvironmentMap* map;
  };
  using Extent = std::variant<PointOfLight, LightDisc, SurfaceLight, EnvironmentLight>;

  /// One of the lights that are chosen from.
  struct Choice {
    Extent extent;
    int source = 0;
    LightReach reach;
  };

  void add_lights();
  void add_shapes();
  void add_environment();
  void add(Choice&& choice);
  [[nodiscard]] double seen_mean(const Curve& spectrum) const;

  // A sample of each kind of extent, as if it were the only one.
  [[nodiscard]] static std::optional<LightSample>
  sample(const PointOfLight& light, const Choice& choice, const dvec3& place, const dvec2& u);
  [[nodiscard]] static std::optional<LightSample>
  sample(const LightDisc& disc, const Choice& choice, const dvec3& place, const dvec2& u);
  [[nodiscard]] static std::optional<LightSample>
  sample(const SurfaceLight& light, const Choice& choice, const dvec3& place, const dvec2& u);
  [[nodiscard]] static std::optional<LightSample>
  sample(const EnvironmentLight& light, const Choice& choice, const dvec3& place, const dvec2& u);

  const Scene& scene_;
  const Plan& plan_;
  BandTable ones_;
  std::vector<Choice> choices_;
  LightHierarchy hierarchy_;        ///< of the choices
  std::vector<int> discs_;          ///< the choices that are discs
  int environment_ = -1;            ///< the choice that is the environment; negative: none
  std::vector<int> light_of_shape_; ///< by ShapeId; negative: none
};

} // namespace abbe
