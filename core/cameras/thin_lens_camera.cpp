#include "core/cameras/thin_lens_camera.h"

#include "core/cameras/focus_distance.h"
#include "geometry/solids/disc_point.h"

namespace abbe {

ThinLensCamera::ThinLensCamera(const ThinLens& lens, const Camera& camera, int width, int height)
    : middle_(camera, width, height), aperture_(lens.aperture),
      focus_distance_(focus_distance(camera, lens.focus_distance)) {}

Ray ThinLensCamera::ray(const glm::dvec2& film, const glm::dvec2& lens) const {
  const glm::dvec2 across = 0.5 * aperture_ / middle_.pixel_angle() * disc_point(lens);
  return middle_.ray_from(across, film, focus_distance_);
}

/// A point of the lens would have to be chosen; light paths leave the light to the photon map.
std::optional<CameraConnection> ThinLensCamera::connect(const dvec3&) const {
  return std::nullopt;
}

ThinLensCamera place(const ThinLens& kind, const Camera& camera, const ImageScale& image) {
  return {kind, camera, image.width, image.height};
}

Projection projection(const ThinLens&, const Camera&, const ImageScale&) {
  return {};
}

double reach(const ThinLens& kind, double) {
  return 0.5 * kind.aperture;
}

} // namespace abbe
