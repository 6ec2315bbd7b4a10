#include "core/cameras/lens_camera.h"

#include "core/sampling/sampler.h"
#include "geometry/solids/disc_point.h"

#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// From the middle of the film to the farthest place of a sample.
double film_radius(const FocusedLens& lens, const ImageScale& image) {
  const double beyond = filter_radius(PixelFilter::gaussian); // the widest
  const double x = 0.5 * image.width + beyond, y = 0.5 * image.height + beyond;
  return lens.film_height / image.height * std::sqrt(x * x + y * y);
}

} // namespace

LensCamera::LensCamera(const RealLens& lens, const Camera& camera, const ImageScale& image)
    : focused_(focused_lens(lens, camera, image.mm_per_unit)), coating_(lens.coating),
      mm_per_unit_(image.mm_per_unit), eye_(camera.eye),
      backward_(glm::normalize(camera.eye - camera.look_at)),
      center_(0.5 * image.width, 0.5 * image.height),
      pixel_mm_(focused_.film_height / image.height),
      pixel_angle_(focused_.image_slope() / image.height),
      pupil_(focused_, film_radius(focused_, image)) {
  right_ = glm::normalize(glm::cross(camera.up, backward_));
  up_ = glm::cross(backward_, right_);
}

std::optional<LensCamera::FilmRay> LensCamera::film_ray(const glm::dvec2& position,
                                                        const glm::dvec2& u) const {
  // The lens turns the picture upside down: what is seen to the right and below comes to the left
  // and above.
  const glm::dvec2 p = pixel_mm_ * (position - center_);
  const glm::dvec2 film{-p.x, p.y};
  const double radius = std::sqrt(film.x * film.x + film.y * film.y);
  const PupilEllipse* pupil = pupil_.at(radius);
  if (!pupil) return std::nullopt;
  const glm::dvec2 outward = radius > 0.0 ? film / radius : glm::dvec2(1.0, 0.0);
  glm::dvec2 q = pupil->semi_axes * disc_point(u);
  q.x += pupil->center;
  const double last = focused_.lens.last_vertex(), distance = focused_.film_distance;
  const dvec3 from{film.x, film.y, last + distance};
  const dvec3 to{outward.x * q.x - outward.y * q.y, outward.y * q.x + outward.x * q.y, last};
  const dvec3 way = to - from;
  // dE = L cos^2 dA / r^2, and cos = distance / r.
  const double cos2 = distance * distance / glm::dot(way, way);
  const double irradiance = pupil->area() * cos2 * cos2 / (distance * distance);
  return FilmRay{{from, glm::normalize(way)}, irradiance / pupil_.axial_irradiance()};
}

Ray LensCamera::to_world(const Ray& ray) const {
  const auto turned = [&](const dvec3& v) { return v.x * right_ + v.y * up_ + v.z * backward_; };
  return {eye_ + turned(ray.origin) / mm_per_unit_, glm::normalize(turned(ray.direction))};
}

/// A way through all of the lens would have to be found; light paths leave the light to the photon
/// map.
std::optional<CameraConnection> LensCamera::connect(const dvec3&) const {
  return std::nullopt;
}

LensCamera place(const RealLens& kind, const Camera& camera, const ImageScale& image) {
  return {kind, camera, image};
}

Projection projection(const RealLens&, const Camera&, const ImageScale&) {
  return {};
}

double reach(const RealLens& kind, double mm_per_unit) {
  const double semi_diameter = LensSystem(kind.prescription).surfaces().front().semi_diameter;
  return std::numbers::sqrt2 * semi_diameter / mm_per_unit;
}

} // namespace abbe
