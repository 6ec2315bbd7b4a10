#pragma once

#include "core/optics/fresnel.h"
#include "geometry/world/world.h"
#include "spectral/glass.h"

#include <stdexcept>

namespace abbe::test {

/// A ray of one wavelength sent straight through glass solids in a world, refracted at each
/// boundary. `index_of` gives n for a medium. Returns the ray behind the last boundary.
template <class IndexOf>
Ray through_glass(const World& world, const Ray& ray, const IndexOf& index_of) {
  RayState state{ray, {}, {}};
  while (const auto hit = world.closest(state)) {
    const dvec3 facing = hit->entering ? hit->normal : -hit->normal;
    const double cos_i = -glm::dot(state.ray.direction, facing);
    const double eta = index_of(hit->medium_after) / index_of(hit->medium_before);
    const auto cos_t = refracted_cosine(cos_i, eta);
    if (!cos_t) throw std::runtime_error("total internal reflection");
    state = {{hit->point, refracted(state.ray.direction, facing, cos_i, *cos_t, eta)},
             hit->other_side,
             hit->nesting_after};
  }
  return state.ray;
}

inline double glass_index(const char* name, double lambda_nm) {
  return refractive_index(find_glass(name)->dispersion, lambda_nm);
}

} // namespace abbe::test
