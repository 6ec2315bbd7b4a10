#pragma once

#include "core/sampling/sampler.h"
#include "geometry/rays/ray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace abbe {

using glm::dvec2;
using glm::dvec3;

/// A ray of a light, the beginning of a light path.
struct LightRay {
  Ray ray;
  double flux = 0.0; ///< per unit of the light's spectrum, over the pdf of the ray
};

/// A ball around something that mirrors or refracts.
struct EmissionTarget {
  dvec3 center{0.0};
  double radius = 0.0; ///< infinite for shapes without end
};

/// A direction from a place to one of the targets, with its pdf.
struct DirectionSample {
  dvec3 direction{0.0};
  double pdf = 0.0; ///< per steradian
};
[[nodiscard]] DirectionSample towards(const std::vector<EmissionTarget>& targets,
                                      const dvec3& place, dvec2 u);

/// The solid angles of the targets as seen from a place, overlaps counted twice; 4 pi at most.
[[nodiscard]] double solid_angles(const std::vector<EmissionTarget>& targets, const dvec3& place);

/// Chooses one of `count` things by a number in [0, 1), which becomes a number in [0, 1) again.
[[nodiscard]] std::size_t one_of(std::size_t count, double& u);

/// A point of parallel light's cross-section.
struct ParallelSample {
  dvec3 place{0.0}; ///< on the line of light, before everything that it can meet
  double pdf = 0.0; ///< per unit of area across the light
};

/// A shape without end, by a point and its unit normal.
struct EndlessPlane {
  dvec3 point, normal;
};

/// What parallel light is sent to: through the discs that balls have across the light.
class ParallelTargets {
public:
  /// `around` is a ball about all shapes with an end, and the eye; lines of light begin before it
  /// and before the planes.
  ParallelTargets(std::vector<EmissionTarget> balls, const EmissionTarget& around,
                  std::vector<EndlessPlane> planes);

  [[nodiscard]] bool empty() const { return balls_.empty(); }
  /// The area of the balls' discs, overlaps counted twice.
  [[nodiscard]] double area() const;
  /// A line of light along a unit direction.
  [[nodiscard]] ParallelSample sample(const dvec3& direction, dvec2 u) const;

private:
  std::vector<EmissionTarget> balls_;
  EmissionTarget around_;
  std::vector<EndlessPlane> planes_;
};

/// Where a light sends its light paths: only to what mirrors or refracts.
struct EmissionGoals {
  std::vector<EmissionTarget> targets;             ///< of light from a place
  std::shared_ptr<const ParallelTargets> parallel; ///< of parallel light; never null
};

/// A ray of parallel light of the value 1 along a unit direction.
[[nodiscard]] LightRay parallel_ray(const dvec3& direction, const ParallelTargets& targets,
                                    const Sampler& sampler);

} // namespace abbe
