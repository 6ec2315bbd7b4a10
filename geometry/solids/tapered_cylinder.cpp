#include "geometry/solids/tapered_cylinder.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

constexpr int kSide = 0, kBottom = 1, kTop = 2;

double cross_xy(const dvec3& a, const dvec3& b) {
  return a.x * b.y - a.y * b.x;
}

double dot_xy(const dvec3& a, const dvec3& b) {
  return a.x * b.x + a.y * b.y;
}

/// The line and the cone that the side is a part of: a t^2 + 2 b t + c = 0 where the distance to
/// the axis is the radius r = 1 + slope z, or its opposite on the nappe beyond the apex. t counts
/// from a point of the line close to the solid, so that far origins cancel nothing.
class SideEquation {
public:
  SideEquation(const TaperedCylinder& solid, const LocalRay& ray)
      : ray_(ray), size_(2.0 + solid.top_radius), steepness_(std::hypot(1.0, solid.slope())) {
    const dvec3& d = ray.direction;
    shift_ = glm::dot(dvec3(0, 0, 0.5) - ray.origin, d) / glm::dot(d, d);
    set(solid, ray.at(shift_));
  }

  /// With the origin on the side one root is 0; the other is -2 b / a.
  SideEquation(const TaperedCylinder& solid, const LocalRay& ray, const FaceContact&)
      : ray_(ray), size_(2.0 + solid.top_radius), steepness_(std::hypot(1.0, solid.slope())) {
    set(solid, ray.origin);
    c_ = 0.0;
    root_d_ = std::abs(b_);
  }

  /// With the origin on the side: whether the line leaves the solid there.
  [[nodiscard]] bool runs_outwards() const { return b_ > 0.0; }

  /// The part of the line inside the nappe that the solid belongs to. `known_inside`: where
  /// rounding finds no root, the line touches.
  [[nodiscard]] std::optional<Interval> inside(bool known_inside) const {
    Interval found;
    if (radius_rate_ == 0.0 && a_ == 0.0) { // along the axis of a cylinder
      if (c_ > 0.0 && !known_inside) return std::nullopt;
      return found;
    }
    if (misses_ && a_ > 0.0 && !known_inside) return std::nullopt;
    // The sum that does not cancel gives one root, Vieta's c / a the other.
    const double q = b_ > 0.0 ? -b_ - root_d_ : -b_ + root_d_;
    if (a_ == 0.0) { // along a line of the cone: one root, the other is endless
      if (q == 0.0) return std::nullopt;
      (radius_rate_ > 0.0 ? found.enter : found.exit) = root(c_ / q, q);
      return found;
    }
    Root near = root(q / a_, q, true), far = q != 0.0 ? root(c_ / q, q) : near;
    if (near.t > far.t) std::swap(near, far);
    if (a_ < 0.0) { // inside both nappes, outside between them
      (radius_rate_ > 0.0 ? found.enter : found.exit) = radius_rate_ > 0.0 ? far : near;
      return found;
    }
    const double middle = 0.5 * (near.t + far.t) - shift_;
    if (!known_inside && radius_ + middle * radius_rate_ < 0.0) return std::nullopt;
    return Interval{near, far};
  }

private:
  void set(const TaperedCylinder& solid, const dvec3& o) {
    const dvec3& d = ray_.direction;
    radius_ = 1.0 + solid.slope() * o.z;
    radius_rate_ = solid.slope() * d.z;
    across_ = dot_xy(d, d);
    a_ = across_ - radius_rate_ * radius_rate_;
    b_ = dot_xy(o, d) - radius_ * radius_rate_;
    c_ = dot_xy(o, o) - radius_ * radius_;
    // b^2 - a c = |r d - r' o|^2 - (o x d)^2, in x and y.
    const dvec3 w = radius_ * d - radius_rate_ * o;
    const double length = std::sqrt(dot_xy(w, w)), moment = std::abs(cross_xy(o, d));
    const double discriminant = (length - moment) * (length + moment);
    misses_ = discriminant < 0.0;
    root_d_ = std::sqrt(std::max(0.0, discriminant));
    // Three roundings in each of the sums above.
    discriminant_error_ = 8.0 * kRoundoff * (length + moment) * (length + moment);
  }

  /// A surface shifted by e changes the equation by 2 r e / cos(slope) =: delta at the root, and
  /// the root by |sqrt(D) - sqrt(D +- a delta)| / |a| <= delta / max(sqrt(D), sqrt(|a| delta)).
  /// To this comes the rounding of sqrt(D), by way of q, and that of `a` where the root is divided
  /// by it; D is computed without `a`, so the other root does not depend on it.
  [[nodiscard]] Root root(double t, double q, bool divided_by_a = false) const {
    const double radius = std::abs(radius_ + t * radius_rate_);
    const double e = ray_.shift_at(std::abs(shift_) + std::abs(t), size_);
    const double delta = 2.0 * e * steepness_ * (radius + e * steepness_);
    const double moved = delta / std::max(root_d_, std::sqrt(std::abs(a_) * delta));
    double error = 8.0 * kRoundoff * std::abs(t);
    if (q != 0.0 && discriminant_error_ > 0.0)
      error +=
          std::abs(t / q) * discriminant_error_ / std::max(root_d_, std::sqrt(discriminant_error_));
    if (divided_by_a)
      error +=
          std::abs(t) * 4.0 * kRoundoff * (across_ + radius_rate_ * radius_rate_) / std::abs(a_);
    const double place = shift_ + t;
    return {place, moved + error + 4.0 * kRoundoff * (std::abs(shift_) + std::abs(t)), {0, kSide}};
  }

  const LocalRay& ray_;
  double size_, steepness_;
  double shift_ = 0.0; ///< of t
  double radius_ = 1.0, radius_rate_ = 0.0, across_ = 0.0;
  double a_ = 0.0, b_ = 0.0, c_ = 0.0;
  bool misses_ = false;
  double root_d_ = 0.0, discriminant_error_ = 0.0;
};

/// The distance from the side's cone, below 0 inside.
double side_height(const TaperedCylinder& solid, const dvec3& point) {
  return (std::sqrt(dot_xy(point, point)) - 1.0 - solid.slope() * point.z) /
         std::hypot(1.0, solid.slope());
}

Root cap_root(const LocalRay& ray, int face) {
  const double t = ((face == kTop ? 1.0 : 0.0) - ray.origin.z) / ray.direction.z;
  return {t, plane_root_error(ray, std::abs(ray.direction.z), t, 1.0), {0, face}};
}

/// Known to be inside: every face but the touched one can only end the interval.
Interval from_contact(const TaperedCylinder& solid, const LocalRay& ray, int touched) {
  Interval found;
  found.enter = {0.0, 0.0, {0, touched}};
  const int ahead = ray.direction.z > 0.0 ? kTop : kBottom;
  if (ray.direction.z != 0.0 && ahead != touched) found.exit = cap_root(ray, ahead);
  const FaceContact contact{touched, Side::inside};
  const SideEquation side =
      touched == kSide ? SideEquation(solid, ray, contact) : SideEquation(solid, ray);
  if (touched == kSide && side.runs_outwards())
    found.exit = {0.0, 0.0, {0, kSide}};
  else if (const auto part = side.inside(true); part && part->exit.t < found.exit.t)
    found.exit = part->exit;
  found.exit.t = std::max(0.0, found.exit.t);
  return found;
}

} // namespace

std::optional<Interval> intersect(const TaperedCylinder& solid, const LocalRay& ray,
                                  const FaceContact* contact) {
  if (contact)
    return contact->side == Side::outside ? std::nullopt // convex: never met again
                                          : std::optional(from_contact(solid, ray, contact->face));
  const double dz = ray.direction.z;
  if (dz == 0.0 && (ray.origin.z < 0.0 || ray.origin.z > 1.0)) return std::nullopt;
  auto found = SideEquation(solid, ray).inside(false);
  if (!found || dz == 0.0) return found;
  const Root enter = cap_root(ray, dz > 0.0 ? kBottom : kTop);
  const Root exit = cap_root(ray, dz > 0.0 ? kTop : kBottom);
  if (enter.t > found->enter.t) found->enter = enter;
  if (exit.t < found->exit.t) found->exit = exit;
  if (found->enter.t > found->exit.t) return std::nullopt;
  return found;
}

dvec3 outward_normal(const TaperedCylinder& solid, const dvec3& point, int face) {
  if (face == kBottom) return {0.0, 0.0, -1.0};
  if (face == kTop) return {0.0, 0.0, 1.0};
  const double distance = std::sqrt(dot_xy(point, point));
  if (distance == 0.0) return {0.0, 0.0, solid.slope() < 0.0 ? 1.0 : -1.0}; // the apex
  return glm::normalize(dvec3(point.x, point.y, -solid.slope() * distance));
}

dvec3 snapped(const TaperedCylinder& solid, const dvec3& point, int face) {
  if (face == kBottom) return {point.x, point.y, 0.0};
  if (face == kTop) return {point.x, point.y, 1.0};
  const double k = solid.slope();
  const double distance = std::sqrt(dot_xy(point, point));
  if (distance == 0.0) return point;
  const double off = (distance - (1.0 + k * point.z)) / (1.0 + k * k);
  const double shrink = (distance - off) / distance;
  return {point.x * shrink, point.y * shrink, point.z + k * off};
}

int nearest_face(const TaperedCylinder& solid, const dvec3& point, const dvec3& direction) {
  const double heights[] = {side_height(solid, point), -point.z, point.z - 1.0};
  int nearest = kSide;
  double highest = -kInfinity;
  for (int face = kSide; face <= kTop; ++face) {
    if (heights[face] <= highest || runs_in(outward_normal(solid, point, face), direction))
      continue;
    highest = heights[face];
    nearest = face;
  }
  return nearest;
}

double signed_distance(const TaperedCylinder& solid, const dvec3& point) {
  return std::max({side_height(solid, point), -point.z, point.z - 1.0});
}

Bounds bounds(const TaperedCylinder& solid, const Transform& to_world) {
  return to_world.disc_box(0.0, 1.0).joined(to_world.disc_box(1.0, solid.top_radius));
}

} // namespace abbe
