#pragma once

#include "core/lights/emission_goals.h"

#include <glm/geometric.hpp>

#include <utility>
#include <vector>

namespace abbe::test {

/// Goals that are these balls, within a ball of radius 100 about the origin.
inline EmissionGoals goals(const std::vector<EmissionTarget>& balls) {
  return {balls, std::make_shared<const ParallelTargets>(balls, EmissionTarget{dvec3(0.0), 100.0},
                                                         std::vector<EndlessPlane>())};
}

/// How far a ray's line passes from a point.
inline double distance_of(const Ray& ray, const dvec3& point) {
  return glm::length(glm::cross(point - ray.origin, ray.direction));
}

} // namespace abbe::test
