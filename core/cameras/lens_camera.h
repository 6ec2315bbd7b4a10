#pragma once

#include "core/cameras/camera_connection.h"
#include "core/cameras/exit_pupil.h"
#include "core/cameras/focused_lens.h"
#include "core/cameras/image_scale.h"

#include <glm/vec2.hpp>

#include <optional>
#include <span>

namespace abbe {

/// A camera with a real lens, ready to shoot rays through an image of a given size. Each wavelength
/// takes its own way through the glass, so colour fringes, focus shift and vignetting are those of
/// the lens; light that is reflected to and fro inside it (ghosts) is left out.
///
/// Exposure: a uniform radiance L in front of the lens gives L in the middle of the picture at the
/// d line, whatever the aperture, and L times the natural vignetting elsewhere: the part of the
/// pupil that is left, and cos^4 of the angle at which its rays meet the film.
class LensCamera {
public:
  /// Throws like focused_lens.
  LensCamera(const RealLens& lens, const Camera& camera, const ImageScale& image);

  /// The way of light from a place on the film to the lens.
  struct FilmRay {
    Ray ray;       ///< in the lens's frame, in mm
    double weight; ///< of what comes along it
  };
  /// `position` is in pixels from the picture's upper left corner; `u` in [0, 1)^2 chooses a place
  /// in the pupil. Nothing where no light comes.
  [[nodiscard]] std::optional<FilmRay> film_ray(const glm::dvec2& position,
                                                const glm::dvec2& u) const;
  /// The ray in front of the lens, in its frame; its transmittance is 1 with coated surfaces.
  /// Nothing where the lens stops it. `n` are the media's indices.
  [[nodiscard]] std::optional<LensRay> trace(const FilmRay& ray, std::span<const double> n) const {
    return focused_.lens.trace_from_film(ray.ray, n, !coating_);
  }
  [[nodiscard]] Ray to_world(const Ray& ray) const;

  static constexpr bool kConnects = false;
  [[nodiscard]] std::optional<CameraConnection> connect(const dvec3& point) const;

  [[nodiscard]] const LensSystem& lens() const { return focused_.lens; }
  /// Width of a pixel in the middle of the image as seen from the first vertex, in radians.
  [[nodiscard]] double pixel_angle() const { return pixel_angle_; }
  /// From the first vertex to what is sharp, in mm; may be infinite.
  [[nodiscard]] double focus_distance() const { return focused_.focus_distance; }
  [[nodiscard]] double mm_per_unit() const { return mm_per_unit_; }

private:
  FocusedLens focused_;
  bool coating_;
  double mm_per_unit_;
  dvec3 eye_, right_, up_, backward_; ///< the lens's frame, of unit length
  glm::dvec2 center_;
  double pixel_mm_, pixel_angle_;
  ExitPupil pupil_;
};

// What PlacedCamera asks of a kind of camera; see placed_camera.h.

[[nodiscard]] LensCamera place(const RealLens& kind, const Camera& camera, const ImageScale& image);
[[nodiscard]] Projection projection(const RealLens& kind, const Camera& camera,
                                    const ImageScale& image);
/// The rim of the first surface lies no farther behind the vertex than from the axis.
[[nodiscard]] double reach(const RealLens& kind, double mm_per_unit);

} // namespace abbe
