#pragma once

#include "core/plan/plan.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace abbe {

using glm::dvec2;

/// A ball around something that mirrors or refracts.
struct EmissionTarget {
  dvec3 center{0.0};
  double radius = 0.0; ///< infinite for shapes without end
};

/// The shapes that light paths may go by: balls around those that mirror or refract.
[[nodiscard]] std::vector<EmissionTarget> specular_targets(const Scene& scene, const Plan& plan);

/// A direction from a place to one of the targets.
struct DirectionSample {
  dvec3 direction{0.0};
  double density = 0.0; ///< per steradian
};
[[nodiscard]] DirectionSample towards(const std::vector<EmissionTarget>& targets,
                                      const dvec3& place, dvec2 u);

/// The solid angles of the targets as seen from a place, overlaps counted twice; 4 pi at most.
[[nodiscard]] double solid_angles(const std::vector<EmissionTarget>& targets, const dvec3& place);

/// Of `count` things one, by a number in [0, 1) that becomes a number in [0, 1) again.
[[nodiscard]] std::size_t one_of(std::size_t count, double& u);

/// A point of parallel light's cross-section.
struct ParallelSample {
  dvec3 place{0.0};     ///< on the line of light, before everything that it can meet
  double density = 0.0; ///< per unit of area across the light
};

/// What parallel light is sent to. A mirror without end is met by light that comes to it on its
/// way to the ball about all shapes with an end and the eye: light that goes through that ball's
/// mirror image.
class ParallelTargets {
public:
  ParallelTargets() = default;
  ParallelTargets(const Scene& scene, const Plan& plan);

  [[nodiscard]] bool empty() const { return balls_.empty(); }
  /// The area of their discs, overlaps counted twice.
  [[nodiscard]] double area() const;
  /// A line of light along a unit direction.
  [[nodiscard]] ParallelSample sample(const dvec3& direction, dvec2 u) const;

private:
  struct EndlessPlane {
    dvec3 point, normal;
  };
  std::vector<EmissionTarget> balls_;
  EmissionTarget around_; ///< all shapes with an end, and the eye
  std::vector<EndlessPlane> planes_;
};

} // namespace abbe
