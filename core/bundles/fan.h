#pragma once

#include "core/bundles/band_partition.h"
#include "core/bundles/bundle.h"
#include "core/bundles/path_wavelengths.h"
#include "core/bundles/statistics.h"
#include "geometry/world/world.h"

#include <vector>

namespace abbe {

/// A sub-bundle behind a boundary.
struct FanCell {
  BandRange bands;
  float weight = 1.0f; ///< 1 / probability that these bands were kept
  bool shared = false; ///< its ray is none of the single bands' rays
  const RayState* state = nullptr;
  const Hit* hit = nullptr; ///< what its ray meets; null for a ray that is not traced yet
  double separation = 0.0, divergence = 0.0; ///< as of a Bundle
  double adjoint = 1.0;                      ///< factor on flux, see adjoint_factor
};

/// Makes `next` the sub-bundle with which `bundle` goes on behind its hit. Both may be the same.
void go_on_as(const FanCell& cell, const Bundle& bundle, Bundle& next);

/// Splits bundles where a boundary bends each band along a direction of its own. This is the one
/// place in a scene where dispersion parts bands:
///   tolerance: bands go on sharing a ray while the rays of the outermost two of them meet the same
///     surface closer together than a fraction of the pixel's width there;
///   roulette: no more than a path's share of sub-bundles is followed; a range of bands that would
///     need more keeps one band, chosen by the bands' shares, with the weight of all.
/// Rays are traced here only where several are, as their hits tell which bands may share one.
class Fan {
public:
  Fan(const Plan& plan, const World& world, double pixel_angle);

  /// What decides how finely a bundle parts, and what is kept of it.
  struct Limits {
    double importance; ///< how much of what the bands meet they bring to the image
    double choice;     ///< the path's number for the roulette, in [0, 1)
  };

  /// The incoming bundle refracted at its hit for some of its bands, all of which pass. The result
  /// is valid until the next call; `counts` grows by the rays that were traced.
  const std::vector<FanCell>& refract(const Bundle& bundle, BandRange bands, const Limits& limits,
                                      PathWavelengths& wavelengths, RayCounts& counts);

private:
  struct Judge;

  void prepare(const Bundle& bundle, BandRange bands, PathWavelengths& wavelengths);
  [[nodiscard]] const dvec3& refracted_direction(int band);
  [[nodiscard]] dvec3 refracted_direction(double n_before, double n_after) const;
  [[nodiscard]] double adjoint_of(double n_before, double n_after) const;
  std::size_t add_ray(const dvec3& direction);
  [[nodiscard]] const dvec3& direction_of(int band) const;
  [[nodiscard]] const Hit& hit_of(int band) const;
  void want(int band);
  void trace_new_rays(RayCounts& counts);
  void add_band(int band, float weight);
  void add_shared(BandRange range, PathWavelengths& wavelengths);
  FanCell& add_shared_ray(BandRange range, double n_before, double n_after);
  [[nodiscard]] bool all_would_leave(BandRange range) const;
  [[nodiscard]] bool may_share(BandRange range) const;
  [[nodiscard]] bool goes_on_behind(const Hit& hit) const;
  [[nodiscard]] double parted(BandRange range);
  bool part_by_directions(BandRange whole, std::size_t most, RayCounts& counts);
  [[nodiscard]] std::size_t sub_bundles_allowed(BandRange range) const;
  void cut(BandRange whole);
  void part(BandRange whole, PathWavelengths& wavelengths, RayCounts& counts);
  void keep_one_of_each_stratum();
  const std::vector<FanCell>& untraced();

  const Plan& plan_;
  const World& world_;
  double tolerance_; ///< by which directions may differ

  const Bundle* incoming_ = nullptr;
  dvec3 facing_normal_{0.0};
  double cos_i_ = 0.0;
  double separation_ = 0.0, divergence_ = 0.0; ///< of the bundle, at its hit and behind it
  Limits limits_{};
  const double* n_before_ = nullptr;
  const double* n_after_ = nullptr;

  /// The direction of a band's own ray behind a boundary, worked out when it is first asked for.
  struct BandDirection {
    dvec3 direction;
    std::uint64_t boundary = 0;
  };
  std::vector<BandDirection> directions_;
  std::uint64_t boundary_ = 0; ///< counts the boundaries

  // Rays in the order in which they were asked for: one for a band at most, and one for a cell.
  std::size_t ray_count_ = 0, traced_count_ = 0;
  std::vector<RayState> states_;
  std::vector<Hit> hits_;
  std::vector<int> ray_of_band_; ///< negative: none yet
  BandPartition partition_;
  std::vector<BandRange> strata_; ///< ranges of which one band each goes on
  std::vector<FanCell> cells_;
};

} // namespace abbe
