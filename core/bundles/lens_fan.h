#pragma once

#include "core/bundles/bundle.h"
#include "core/cameras/lens_camera.h"
#include "core/plan/plan.h"

#include <vector>

namespace abbe {

/// Parts the bands of a camera sample where the lens bends each its own way, by the rules of Fan:
///   tolerance: bands share a ray while those of the outermost two, and of the middle one, leave
///   the
///     lens close together;
///   roulette: at most `max_fan` sub-bundles start; a range of bands that would need more keeps one
///   band, chosen by the bands' shares, with the weight of all.
///
/// Close together means: in direction, less apart than a fraction of the pixel's angle, which holds
/// for what lies behind the plane of focus; and less apart than the same fraction of the pixel's
/// width in that plane, both there and at the lens. What lies before the plane is out of focus, and
/// blurred by more than that. A plane of focus at infinity leaves the first of these alone.
///
/// One object serves one thread.
class LensFan {
public:
  LensFan(const Plan& plan, const LensCamera& camera);

  /// Appends the bundles of a sample to `bundles` and their rays, without nesting, to `states`.
  /// `wavelength` is the path's: x the place inside the bands, y the roulette's number. Bands whose
  /// rays the lens stops are left out.
  void sample(const glm::dvec2& position, const glm::dvec2& u_lens, const glm::dvec2& wavelength,
              std::vector<CameraBundle>& bundles, std::vector<RayState>& states);

private:
  struct BandRay {
    std::optional<LensRay> ray;
    bool traced = false;
  };
  struct Spread {
    double direction = 0.0;                ///< rad
    double position = 0.0, in_focus = 0.0; ///< mm, where they leave the lens and farther on
  };

  [[nodiscard]] const std::optional<LensRay>& band_ray(int band);
  [[nodiscard]] std::optional<LensRay> traced(double lambda_nm);
  [[nodiscard]] bool stopped(BandRange range);
  [[nodiscard]] std::optional<Spread> spread(BandRange range);
  [[nodiscard]] bool may_share(BandRange range);
  void part(BandRange whole);
  void add(BandRange range, const std::optional<LensRay>& ray, double weight);
  void add_shared(BandRange range);

  const Plan& plan_;
  const LensCamera& camera_;
  bool achromatic_;
  double direction_limit_, position_limit_; ///< rad, mm

  LensCamera::FilmRay film_ray_{};
  glm::dvec2 wavelength_{0.5};
  std::vector<double> n_; ///< the media's indices at one wavelength
  std::vector<BandRay> band_rays_;
  std::vector<BandRange> ranges_, next_ranges_;
  std::vector<CameraBundle>* bundles_ = nullptr; ///< where the sample's go
  std::vector<RayState>* states_ = nullptr;
};

} // namespace abbe
