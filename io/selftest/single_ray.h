#pragma once

#include "geometry/world/world.h"

#include <numbers>

namespace abbe {

inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// What a ray of one wavelength does that goes straight through glass solids.
struct SingleRay {
  Ray ray;            ///< behind the last boundary
  int boundaries = 0; ///< how many it has crossed
};

/// Follows a ray through a world and refracts it at each boundary; `index_of` gives n for a medium.
/// Throws std::runtime_error where a boundary reflects all of it.
template <class IndexOf>
SingleRay refracted_through(const World& world, const Ray& ray, const IndexOf& index_of);

/// The same where every solid has one index and stands in air.
[[nodiscard]] SingleRay refracted_through(const World& world, const Ray& ray, double n);

/// The ray refracted at a boundary that it has met, between the indices before and behind. Throws
/// std::runtime_error where all of it is reflected.
[[nodiscard]] RayState refracted_at(const Hit& hit, const Ray& ray, double n_before,
                                    double n_after);

template <class IndexOf>
SingleRay refracted_through(const World& world, const Ray& ray, const IndexOf& index_of) {
  RayState state{ray, {}, {}};
  int boundaries = 0;
  for (; const auto hit = world.closest(state); ++boundaries)
    state =
        refracted_at(*hit, state.ray, index_of(hit->medium_before), index_of(hit->medium_after));
  return {state.ray, boundaries};
}

} // namespace abbe
