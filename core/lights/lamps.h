#pragma once

#include "core/plan.h"
#include "geometry/ray_state.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace abbe {

using glm::dvec2;

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
  int source = 0; ///< index into Plan::sources
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

private:
  struct Lamp {
    int light = -1; ///< index into Scene::lights; negative: a shape
    ShapeId shape;
    int source = 0;
    double power = 0.0;
    double chance = 0.0;     ///< of being chosen
    double cumulative = 0.0; ///< of this one and those before it
  };
  void add_lights();
  void add_shapes();
  void share_chances();
  [[nodiscard]] std::optional<LampSample> sample_light(const Lamp& lamp, const dvec3& place) const;
  [[nodiscard]] std::optional<LampSample> sample_shape(const Lamp& lamp, const dvec3& place,
                                                       const dvec2& u) const;

  const Scene& scene_;
  const Plan& plan_;
  std::vector<Lamp> lamps_;
  std::vector<int> lamp_of_shape_; ///< by ShapeId; negative: none
};

} // namespace abbe
