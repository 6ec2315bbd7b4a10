#pragma once

#include "core/cameras/pinhole_camera.h"

namespace abbe {

/// A thin lens, ready to shoot rays through an image of a given size. It shows what lies in the
/// plane of focus as the pinhole in its middle does, all else blurred; a uniform radiance looks the
/// same through both.
class ThinLensCamera {
public:
  ThinLensCamera(const ThinLens& lens, const Camera& camera, int width, int height);

  /// The ray through a point of the image in pixels from a point of the lens, which two numbers in
  /// [0, 1) choose.
  [[nodiscard]] Ray ray(const glm::dvec2& film, const glm::dvec2& lens) const;
  [[nodiscard]] Ray ray(const glm::dvec2& film, const Sampler& sampler) const {
    return ray(film, sampler.pair(kLens));
  }

  static constexpr bool kConnects = false;
  [[nodiscard]] std::optional<CameraConnection> connect(const dvec3& point) const;

  /// Width of a pixel in the middle of the image as seen from the lens's middle, in radians.
  [[nodiscard]] double pixel_angle() const { return middle_.pixel_angle(); }

private:
  PinholeCamera middle_;
  double aperture_, focus_distance_;
};

// What PlacedCamera asks of a kind of camera; see placed_camera.h.

[[nodiscard]] ThinLensCamera place(const ThinLens& kind, const Camera& camera,
                                   const ImageScale& image);
[[nodiscard]] Projection projection(const ThinLens& kind, const Camera& camera,
                                    const ImageScale& image);
[[nodiscard]] double reach(const ThinLens& kind, double mm_per_unit);

} // namespace abbe
