#pragma once

#include "core/scene/light.h"
#include "geometry/rays/transform.h"

namespace abbe {

/// What one light, or several together, can send to a place: where it stands, which way it shines
/// and how strongly. It is for choosing among lights, so it may be too much, but where light
/// arrives it is never nothing.
class LightReach {
public:
  /// Light from a box to all sides: irradiance at the distance 1, of what falls off with its
  /// square, and at any distance, of what does not fall off.
  LightReach(const Bounds& box, double falling, double steady)
      : box_(box), falling_(falling), steady_(steady) {}

  /// Parallel light of this irradiance, or other light from infinitely far away.
  [[nodiscard]] static LightReach distant(double steady) { return {{}, 0.0, steady}; }

  /// The same light, but it shines only where this says: the normals of what gives it off lie
  /// within the angle `normals` of the unit vector `axis`, and it leaves within the angle `spread`
  /// of them, by the cosine (radians, together at most pi): pi / 2 for surfaces, 0 for a point that
  /// shines fully wherever it shines.
  [[nodiscard]] LightReach along(const dvec3& axis, double normals, double spread) const;

  [[nodiscard]] const Bounds& box() const { return box_; }
  [[nodiscard]] bool is_distant() const { return box_.empty(); }
  /// Of all of it, without regard to distance.
  [[nodiscard]] double strength() const { return falling_ + steady_; }
  /// The same light, brighter.
  [[nodiscard]] LightReach times(double factor) const;

  /// The irradiance that can be expected at a place, as from the middle of the box; 0 only where
  /// none of the light arrives.
  [[nodiscard]] double at(const dvec3& place) const;

  /// The reach of both; neither may be distant.
  [[nodiscard]] LightReach joined(const LightReach& other) const;

  /// The solid angle into which light goes, less where it is weaker [Conty18].
  [[nodiscard]] double solid_angle() const;

private:
  [[nodiscard]] double normals() const;
  [[nodiscard]] double spread() const;

  Bounds box_;
  dvec3 axis_{0.0, 0.0, 1.0};
  double cos_normals_ = -1.0, sin_normals_ = 0.0; ///< all directions
  double cos_spread_ = 1.0, sin_spread_ = 0.0;
  double falling_ = 0.0, steady_ = 0.0;
};

/// The reach of a light of this value that shines from a point to all sides.
[[nodiscard]] LightReach reach_from(const dvec3& position, Falloff falloff, double value);

} // namespace abbe
