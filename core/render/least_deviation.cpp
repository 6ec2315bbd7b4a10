#include "core/render/least_deviation.h"

#include "core/render/seen_through.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace abbe {
namespace {

/// How far the two rays beside the ray are inclined to it, in radians.
constexpr double kBeside = 1e-4;
/// Halvings of the range of wavelengths: 400 nm become 0.01 nm.
constexpr int kHalvings = 15;

SeenThrough seen_from(const Plan& plan, const World& world, const RayState& state, double nm) {
  Hit hit;
  world.find_closest(state, hit);
  return see_through(plan, world, state, hit, nm);
}

/// By how much more the ray on one side is turned than that on the other.
std::optional<double> slope(const Plan& plan, const World& world, const RayState& state,
                            double nm) {
  const SeenThrough middle = seen_from(plan, world, state, nm);
  const dvec3 begin = state.ray.direction, axis = glm::cross(begin, middle.direction);
  if (middle.surfaces < 2 || glm::dot(axis, axis) == 0.0) return std::nullopt;
  const dvec3 across = glm::cross(glm::normalize(axis), begin);
  double difference = 0.0;
  for (const double side : {1.0, -1.0}) {
    RayState beside = state;
    beside.ray.direction = glm::normalize(begin + side * kBeside * across);
    const SeenThrough seen = seen_from(plan, world, beside, nm);
    if (seen.surfaces != middle.surfaces) return std::nullopt;
    difference += side * seen.deviation;
  }
  return difference;
}

} // namespace

std::optional<double> least_deviation_nm(const Plan& plan, const World& world,
                                         const RayState& state) {
  double low = plan.grid.lower_nm(0), high = plan.grid.lower_nm(plan.grid.count());
  const auto at_low = slope(plan, world, state, low), at_high = slope(plan, world, state, high);
  if (!at_low || !at_high || (*at_low > 0.0) == (*at_high > 0.0)) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const auto here = slope(plan, world, state, middle);
    if (!here) return std::nullopt;
    ((*here > 0.0) == (*at_low > 0.0) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace abbe
