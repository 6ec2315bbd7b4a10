#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace abbe {

using glm::dvec3;

/// The shape of a lens surface about the z axis, with its vertex at the origin: a sphere, a conic
/// section of revolution or an even asphere [Welford86]. At the height h its sag is
///
///   c h^2 / (1 + sqrt(1 - (1 + k) c^2 h^2)) + a_2 h^2 + a_4 h^4 + a_6 h^6 + ...
struct LensProfile {
  double curvature = 0.0;           ///< c, 1 / radius
  double conic = 0.0;               ///< k; 0: a sphere, -1: a paraboloid
  std::vector<double> even_terms{}; ///< a_2, a_4, a_6 ...

  [[nodiscard]] bool spherical() const { return conic == 0.0 && even_terms.empty(); }
  /// That of the sphere which touches the vertex most closely.
  [[nodiscard]] double vertex_curvature() const;
  /// True when the conic has a point at this height.
  [[nodiscard]] bool reaches(double height) const;
  [[nodiscard]] double sag(double height) const;
  /// No point up to this height has a larger sag than this, or than 0.
  [[nodiscard]] double most_sag(double height) const;
  /// d(sag)/d(h^2), twice of which, times x and y, are the slopes along these axes.
  [[nodiscard]] double slope(double height2) const;
};

/// Where a ray that passes the vertex's plane at `q` (with q.z = 0) along the unit direction `d`,
/// d.z not 0, meets a profile that ends at the height `semi_diameter`, which the profile reaches.
/// The parameter counts from q; its error is the last few digits of what the sag at that place is
/// computed to. Beyond its end the profile goes on as a plane, so that there always is a root; one
/// that is met there lies outside of the semi-diameter.
[[nodiscard]] double meet_profile(const LensProfile& profile, double semi_diameter, const dvec3& q,
                                  const dvec3& d);

} // namespace abbe
