#include "core/lamps/emission_targets.h"

#include "core/emitters/cone.h"
#include "core/optics/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

EmissionTarget ball_around(const Bounds& box) {
  return {0.5 * (box.lower + box.upper), 0.5 * glm::length(box.upper - box.lower)};
}

/// Calls `visit(placed, reflects, transmits)` for the shapes with a part that mirrors or refracts.
template <class Visit>
void for_each_specular(const Scene& scene, const Plan& plan, Visit&& visit) {
  for (const PlacedShape& placed : scene.shapes) {
    const bool of_drops = placed.medium.valid() && plan.medium(placed.medium).drops;
    if (of_drops && plan.materials[placed.material.index()].clear) continue; // bends no light
    bool reflects = false, transmits = false;
    const auto add = [&](MaterialId id) {
      if (!id.valid()) return;
      const BsdfFacts facts = plan.materials[id.index()].facts();
      if (!facts.specular()) return;
      reflects = reflects || facts.reflects;
      transmits = transmits || facts.transmits;
    };
    add(placed.material);
    if (const auto* tree = std::get_if<CsgTree>(&placed.shape))
      for (const auto& leaf : tree->leaves())
        add(leaf.material);
    if (reflects || transmits) visit(placed, reflects, transmits);
  }
}

} // namespace

std::size_t one_of(std::size_t count, double& u) {
  const double x = u * static_cast<double>(count);
  const std::size_t i = std::min(static_cast<std::size_t>(x), count - 1);
  u = std::min(x - static_cast<double>(i), 1.0 - 0x1p-53);
  return i;
}

std::vector<EmissionTarget> specular_targets(const Scene& scene, const Plan& plan) {
  std::vector<EmissionTarget> targets;
  for_each_specular(scene, plan, [&](const PlacedShape& placed, bool, bool) {
    targets.push_back(is_bounded(placed.shape)
                          ? ball_around(bounds(placed))
                          : EmissionTarget{dvec3(0.0), std::numeric_limits<double>::infinity()});
  });
  return targets;
}

double solid_angles(const std::vector<EmissionTarget>& targets, const dvec3& place) {
  double sum = 0.0;
  for (const EmissionTarget& target : targets)
    sum += cone_to_ball(place, target.center, target.radius).solid_angle();
  return std::min(sum, 4.0 * kPi);
}

DirectionSample towards(const std::vector<EmissionTarget>& targets, const dvec3& place, dvec2 u) {
  const std::size_t chosen = one_of(targets.size(), u.x);
  const Cone cone = cone_to_ball(place, targets[chosen].center, targets[chosen].radius);
  const dvec3 direction = cone.sample(u);
  double density = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Cone other =
        i == chosen ? cone : cone_to_ball(place, targets[i].center, targets[i].radius);
    // Rounding must not put a direction outside the cone it was drawn from.
    if (i == chosen || other.holds(direction)) density += 1.0 / other.solid_angle();
  }
  return {direction, density / static_cast<double>(targets.size())};
}

ParallelTargets::ParallelTargets(const Scene& scene, const Plan& plan) {
  Bounds box{scene.camera.eye, scene.camera.eye};
  for (const PlacedShape& placed : scene.shapes) {
    if (is_bounded(placed.shape))
      box = box.joined(bounds(placed));
    else
      planes_.push_back(
          {placed.to_world.point(dvec3(0.0)), placed.to_world.normal({0.0, 0.0, 1.0})});
  }
  around_ = ball_around(box);
  // With nothing but planes, what is seen of them is about as far as they are.
  if (!(around_.radius > 0.0))
    for (const EndlessPlane& plane : planes_)
      around_.radius =
          std::max(around_.radius, std::abs(glm::dot(around_.center - plane.point, plane.normal)));
  for_each_specular(scene, plan, [&](const PlacedShape& placed, bool reflects, bool transmits) {
    if (is_bounded(placed.shape)) {
      balls_.push_back(ball_around(bounds(placed)));
      return;
    }
    if (transmits) balls_.push_back(around_);
    if (!reflects) return;
    const dvec3 normal = placed.to_world.normal({0.0, 0.0, 1.0});
    const double above = glm::dot(around_.center - placed.to_world.point(dvec3(0.0)), normal);
    balls_.push_back({around_.center - 2.0 * above * normal, around_.radius});
  });
  std::erase_if(balls_, [](const EmissionTarget& ball) { return !(ball.radius > 0.0); });
}

double ParallelTargets::area() const {
  double sum = 0.0;
  for (const EmissionTarget& ball : balls_)
    sum += kPi * ball.radius * ball.radius;
  return sum;
}

ParallelSample ParallelTargets::sample(const dvec3& direction, dvec2 u) const {
  const Frame frame(direction);
  const std::size_t chosen = one_of(balls_.size(), u.x);
  const dvec2 across = balls_[chosen].radius * std::sqrt(u.x) * circle_point(u.y);
  const dvec3 place = balls_[chosen].center + across.x * frame.x + across.y * frame.y;
  double density = 0.0;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const EmissionTarget& ball = balls_[i];
    const dvec3 apart = place - ball.center;
    const double across2 = glm::dot(apart, apart) - std::pow(glm::dot(apart, direction), 2);
    if (i == chosen || across2 < ball.radius * ball.radius)
      density += 1.0 / (kPi * ball.radius * ball.radius);
  }
  // The line begins before all shapes: how far back from the place that is.
  double back = glm::dot(place - around_.center, direction) + 2.0 * around_.radius;
  for (const EndlessPlane& plane : planes_) {
    const double to_plane = glm::dot(place - plane.point, plane.normal);
    const double slope = glm::dot(direction, plane.normal);
    if (slope != 0.0) back = std::max(back, to_plane / slope + around_.radius);
  }
  return {place - back * direction, density / static_cast<double>(balls_.size())};
}

} // namespace abbe
