#pragma once

#include "core/bundle.h"
#include "core/path_wavelengths.h"
#include "core/statistics.h"
#include "geometry/world.h"

#include <vector>

namespace abbe {

/// A sub-bundle behind a boundary, traced to what it meets next.
struct FanCell {
  Bundle bundle;
  float weight = 1.0f; ///< 1 / probability that these bands were kept
  bool shared = false; ///< its ray is none of the single bands' rays
};

/// Splits bundles where a boundary bends each band its own way. This is the one place where
/// dispersion parts bands:
///   tolerance: bands go on sharing a ray while the rays of the outermost two of them meet the same
///     surface closer together than a fraction of the pixel's width there;
///   roulette: no more than a path's share of sub-bundles is followed; a range of bands that would
///     need more keeps one band, chosen uniformly, with the weight of all.
class Fan {
public:
  Fan(const Plan& plan, const World& world, double pixel_angle);

  /// The incoming bundle refracted at its hit for bands [first, last), all of which pass.
  /// `importance` is how much of what they meet they bring to the picture; it sets how finely they
  /// may part. `choice` in [0, 1) is the path's number for the roulette. The result is valid until
  /// the next call; `counts` grows by the rays that were needed.
  const std::vector<FanCell>& refract(const Bundle& bundle, int first, int last, double importance,
                                      PathWavelengths& wavelengths, double choice,
                                      RayCounts& counts);

private:
  struct BandRay {
    RayState state;
    std::optional<Hit> hit;
    bool traced = false;
  };
  struct Range {
    int first, last;
  };

  void prepare(const Bundle& bundle, int first, int last, PathWavelengths& wavelengths);
  [[nodiscard]] RayState refracted_state(double n_before, double n_after) const;
  void want(int band);
  void trace_bands(RayCounts& counts);
  void trace_shared_cells(RayCounts& counts);
  void add_band(int band, float weight);
  void add_shared(Range range, PathWavelengths& wavelengths);
  void add_undivided(Range range);
  [[nodiscard]] bool all_would_leave(Range range) const;
  [[nodiscard]] bool may_share(Range range) const;
  [[nodiscard]] std::size_t sub_bundles_allowed(Range range, double importance) const;
  void cut(Range whole, double importance);
  void part(Range whole, double importance, PathWavelengths& wavelengths, RayCounts& counts);
  void keep_one_of_each_stratum(double choice, RayCounts& counts);

  const Plan& plan_;
  const World& world_;
  double pixel_angle_;

  const Bundle* incoming_ = nullptr;
  dvec3 facing_normal_{0.0};
  double cos_i_ = 0.0;
  double position_spread_ = 0.0, carried_direction_spread_ = 0.0; ///< of the bundle, at its hit
  const double* n_before_ = nullptr;
  const double* n_after_ = nullptr;

  std::vector<BandRay> band_rays_;
  std::vector<int> wanted_; ///< bands whose rays are to be traced next
  std::vector<Range> ranges_, next_ranges_, strata_;
  std::vector<RayState> packet_states_;
  std::vector<std::optional<Hit>> packet_hits_;
  std::vector<FanCell> cells_;
};

} // namespace abbe
