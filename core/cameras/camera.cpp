#include "core/cameras/camera.h"

#include "geometry/disc_point.h"

#include <cmath>
#include <numbers>

namespace abbe {

double focus_distance(const Camera& camera) {
  return camera.focus_distance.value_or(glm::distance(camera.look_at, camera.eye));
}

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : eye_(camera.eye), forward_(glm::normalize(camera.look_at - camera.eye)),
      center_(0.5 * width, 0.5 * height),
      pixel_angle_(2.0 * std::tan(camera.field_of_view_deg * std::numbers::pi / 360.0) / height),
      aperture_(camera.aperture), focus_distance_(focus_distance(camera)) {
  const dvec3 right = glm::normalize(glm::cross(forward_, camera.up));
  right_ = pixel_angle_ * right;
  down_ = pixel_angle_ * glm::cross(forward_, right);
}

Ray CameraRays::ray(const glm::dvec2& position) const {
  const glm::dvec2 p = position - center_;
  return {eye_, glm::normalize(forward_ + p.x * right_ + p.y * down_)};
}

Ray CameraRays::ray(const glm::dvec2& position, const glm::dvec2& lens) const {
  const glm::dvec2 p = position - center_;
  const glm::dvec2 l = 0.5 * aperture_ / pixel_angle_ * disc_point(lens);
  const dvec3 from = l.x * right_ + l.y * down_; // right_ and down_ are pixel_angle_ long
  return {eye_ + from,
          glm::normalize(forward_ + p.x * right_ + p.y * down_ - from / focus_distance_)};
}

std::optional<glm::dvec2> CameraRays::project(const dvec3& point) const {
  const dvec3 v = point - eye_;
  const double depth = glm::dot(v, forward_);
  if (!(depth > 0.0)) return std::nullopt;
  const double scale = 1.0 / (depth * pixel_angle_ * pixel_angle_);
  return center_ + scale * glm::dvec2(glm::dot(v, right_), glm::dot(v, down_));
}

} // namespace abbe
