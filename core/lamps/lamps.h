#pragma once

#include "core/emitters/cone.h"
#include "core/emitters/sampled_surface.h"
#include "core/film/radiance_sums.h"
#include "geometry/ray_state.h"

#include <optional>
#include <vector>

namespace abbe {

/// A lamp as chosen for a place that it may light.
struct LampSample {
  dvec3 direction{0.0};  ///< unit, towards the lamp
  double distance = 0.0; ///< infinite for parallel light
  /// With which the direction was chosen, per steradian; 0 for lamps without extent, which no ray
  /// meets by chance.
  double density = 0.0;
  /// Factor on the source's spectrum: radiance over density; for lamps without extent irradiance
  /// at normal incidence over the chance of having chosen this lamp.
  double weight = 0.0;
  int source = 0;           ///< index into Plan::sources
  bool environment = false; ///< the picture's colour of this direction counts too
};

/// Everything that can be aimed at to light a place: the scene's lights, and shapes whose finish
/// emits. One of them is chosen in proportion to its power.
class Lamps {
public:
  /// Keeps references to both.
  Lamps(const Scene& scene, const Plan& plan);

  [[nodiscard]] bool empty() const { return lamps_.empty(); }
  /// True when no number is needed to choose one.
  [[nodiscard]] bool single() const { return lamps_.size() == 1; }

  /// A lamp (by `choice` in [0, 1)) and a point on it (by `u`), as seen from a place. Nothing where
  /// it does not shine.
  [[nodiscard]] std::optional<LampSample> sample(const dvec3& place, double choice,
                                                 const dvec2& u) const;

  /// The density, per steradian, with which `sample` would have chosen the direction from `place`
  /// to an emitting surface that a ray met. 0 for surfaces that are not aimed at.
  [[nodiscard]] double density(const dvec3& place, const Hit& hit) const;

  /// Multiplies the light of a sample per band by what is not in its weight and its source: the
  /// colour of an environment.
  void tint(const LampSample& lamp, int first, int last, float* light) const {
    if (lamp.environment) plan_.environment->scale(lamp.direction, first, last, light);
  }

  /// Adds what a ray sees that leaves the scene along a unit direction: the background, the discs
  /// of suns (unless they are found otherwise), and the environment, each weighed against `sample`
  /// where the ray was spread with this density per steradian (0: it was not). The ray ends there:
  /// its throughput is changed.
  void add_sky(const dvec3& direction, double density, bool suns, float* throughput, int first,
               int last, RadianceSums& sums) const;

private:
  struct Lamp {
    int light = -1;                        ///< index into Scene::lights; negative: a shape
    std::optional<SampledSurface> surface; ///< of a shape
    bool solid = false;                    ///< the shape gives light off outwards only
    std::optional<Cone> disc;              ///< of a sun
    double radiance = 0.0;                 ///< of that disc, per unit of the spectrum
    bool environment = false;
    int source = 0;
    double power = 0.0;
    double chance = 0.0;     ///< of being chosen
    double cumulative = 0.0; ///< of this one and those before it
  };
  void add_lights();
  void add_shapes();
  void add_environment();
  void share_chances();
  [[nodiscard]] std::optional<LampSample> sample_light(const Lamp& lamp, const dvec3& place) const;

  const Scene& scene_;
  const Plan& plan_;
  BandTable ones_;
  std::vector<Lamp> lamps_;
  std::vector<int> suns_;          ///< the lamps that are suns
  int environment_ = -1;           ///< the lamp that is the environment
  std::vector<int> lamp_of_shape_; ///< by ShapeId; negative: none
};

} // namespace abbe
