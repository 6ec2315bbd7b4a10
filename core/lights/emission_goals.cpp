#include "core/lights/emission_goals.h"

#include "core/emitters/cone.h"
#include "core/optics/frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

using std::numbers::pi;

} // namespace

std::size_t one_of(std::size_t count, double& u) {
  const double x = u * static_cast<double>(count);
  const std::size_t i = std::min(static_cast<std::size_t>(x), count - 1);
  u = std::min(x - static_cast<double>(i), 1.0 - 0x1p-53);
  return i;
}

double solid_angles(const std::vector<EmissionTarget>& targets, const dvec3& place) {
  double sum = 0.0;
  for (const EmissionTarget& target : targets)
    sum += cone_to_ball(place, target.center, target.radius).solid_angle();
  return std::min(sum, 4.0 * pi);
}

DirectionSample towards(const std::vector<EmissionTarget>& targets, const dvec3& place, dvec2 u) {
  const std::size_t chosen = one_of(targets.size(), u.x);
  const Cone cone = cone_to_ball(place, targets[chosen].center, targets[chosen].radius);
  const dvec3 direction = cone.sample(u);
  double pdf = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Cone other =
        i == chosen ? cone : cone_to_ball(place, targets[i].center, targets[i].radius);
    // Rounding must not put a direction outside the cone it was drawn from.
    if (i == chosen || other.holds(direction)) pdf += 1.0 / other.solid_angle();
  }
  return {direction, pdf / static_cast<double>(targets.size())};
}

ParallelTargets::ParallelTargets(std::vector<EmissionTarget> balls, const EmissionTarget& around,
                                 std::vector<EndlessPlane> planes)
    : balls_(std::move(balls)), around_(around), planes_(std::move(planes)) {}

double ParallelTargets::area() const {
  double sum = 0.0;
  for (const EmissionTarget& ball : balls_)
    sum += pi * ball.radius * ball.radius;
  return sum;
}

ParallelSample ParallelTargets::sample(const dvec3& direction, dvec2 u) const {
  const Frame frame(direction);
  const std::size_t chosen = one_of(balls_.size(), u.x);
  const dvec2 across = balls_[chosen].radius * std::sqrt(u.x) * circle_point(u.y);
  const dvec3 place = balls_[chosen].center + across.x * frame.x + across.y * frame.y;
  double pdf = 0.0;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const EmissionTarget& ball = balls_[i];
    const dvec3 apart = place - ball.center;
    const double across2 = glm::dot(apart, apart) - std::pow(glm::dot(apart, direction), 2);
    if (i == chosen || across2 < ball.radius * ball.radius)
      pdf += 1.0 / (pi * ball.radius * ball.radius);
  }
  // The line begins before all shapes: how far back from the place that is.
  double back = glm::dot(place - around_.center, direction) + 2.0 * around_.radius;
  for (const EndlessPlane& plane : planes_) {
    const double to_plane = glm::dot(place - plane.point, plane.normal);
    const double slope = glm::dot(direction, plane.normal);
    if (slope != 0.0) back = std::max(back, to_plane / slope + around_.radius);
  }
  return {place - back * direction, pdf / static_cast<double>(balls_.size())};
}

LightRay parallel_ray(const dvec3& direction, const ParallelTargets& targets,
                      const Sampler& sampler) {
  const ParallelSample line = targets.sample(direction, sampler.pair(kEmissionPoint));
  return {{line.place, direction}, pi / line.pdf};
}

} // namespace abbe
