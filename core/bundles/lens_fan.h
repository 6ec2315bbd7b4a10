#pragma once

#include "core/bundles/band_partition.h"
#include "core/bundles/bundle.h"
#include "core/cameras/lens_camera.h"
#include "core/plan/plan.h"

#include <vector>

namespace abbe {

/// Parts the bands of a camera sample where the lens bends each along a direction of its own, by
/// the rules of Fan:
///   tolerance: bands share a ray while those of the outermost two, and of the middle one, leave
///     the lens close together;
///   roulette: at most `max_fan` sub-bundles start; a range of bands that would need more keeps one
///     band, chosen by the bands' shares, with the weight of all.
/// Bands that carry no light do not start, even where the plan carries them: they would move the
/// borders of the others' ranges.
///
/// Rays leave the lens close together when their directions differ by less than a fraction of the
/// pixel's angle, which is what counts behind the plane of focus, and when they are less than the
/// same fraction of the pixel's width in that plane apart, both there and at the lens. What lies
/// before the plane is out of focus, and blurred by more than that. Where the plane of focus is at
/// infinity, only the directions count.
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
  /// How far rays are apart where they leave the lens.
  struct Apart {
    double direction = 0.0; ///< rad
    double position = 0.0;  ///< mm
    double in_focus = 0.0;  ///< mm, in the plane of focus
  };
  struct Judge;

  [[nodiscard]] const std::optional<LensRay>& band_ray(int band);
  [[nodiscard]] std::optional<LensRay> traced(double lambda_nm);
  [[nodiscard]] bool stopped(BandRange range);
  [[nodiscard]] std::optional<Apart> apart(BandRange range);
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
  BandPartition partition_;
  std::vector<CameraBundle>* bundles_ = nullptr; ///< where the sample's bundles go
  std::vector<RayState>* states_ = nullptr;
};

} // namespace abbe
