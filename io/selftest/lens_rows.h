#pragma once

#include "geometry/world/world.h"
#include "io/selftest/selftest_row.h"

#include <array>
#include <span>

namespace abbe {

struct Scene;

/// A lens with its focal lengths, in units of its scene. They were computed from the glasses'
/// dispersion by paraxial matrices, outside this project.
struct PublishedLens {
  const char* name;
  const char* scene; ///< its front vertex is at z = 0, and light comes along +z
  int surfaces;
  std::array<double, 3> focal_length, back_focal_length; ///< at F, d, C
  double back_vertex;                                    ///< its z
};
[[nodiscard]] std::span<const PublishedLens> published_lenses();

/// Where a ray close to the axis goes behind the lenses of a world.
struct ParaxialFocus {
  double focal_length;
  double focus; ///< the z at which the ray crosses the axis
  int boundaries;
};
[[nodiscard]] ParaxialFocus paraxial_focus(const World& world, const Scene& scene,
                                           double lambda_nm);

/// Focal lengths of singlets and achromats, and how they change with wavelength.
[[nodiscard]] SelftestRows lens_rows();

} // namespace abbe
