#include "core/cameras/pinhole_camera.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace abbe {

PinholeCamera::PinholeCamera(const Camera& camera, int width, int height)
    : eye_(camera.eye), forward_(glm::normalize(camera.look_at - camera.eye)),
      center_(0.5 * width, 0.5 * height),
      pixel_angle_(2.0 * std::tan(camera.field_of_view_deg * std::numbers::pi / 360.0) / height) {
  const dvec3 right = glm::normalize(glm::cross(forward_, camera.up));
  right_ = pixel_angle_ * right;
  down_ = pixel_angle_ * glm::cross(forward_, right);
}

Ray PinholeCamera::ray(const glm::dvec2& film) const {
  const glm::dvec2 p = film - center_;
  return {eye_, glm::normalize(forward_ + p.x * right_ + p.y * down_)};
}

Ray PinholeCamera::ray_from(const glm::dvec2& across, const glm::dvec2& film,
                            double distance) const {
  const glm::dvec2 p = film - center_;
  const dvec3 from = across.x * right_ + across.y * down_;
  return {eye_ + from, glm::normalize(forward_ + p.x * right_ + p.y * down_ - from / distance)};
}

std::optional<glm::dvec2> PinholeCamera::project(const dvec3& point) const {
  const dvec3 v = point - eye_;
  const double depth = glm::dot(v, forward_);
  if (!(depth > 0.0)) return std::nullopt;
  const double scale = 1.0 / (depth * pixel_angle_ * pixel_angle_);
  return center_ + scale * glm::dvec2(glm::dot(v, right_), glm::dot(v, down_));
}

/// With the pixels' area A at unit distance along the axis, a place seen at the angle c from the
/// axis and at the distance d adds to the mean radiance of its pixel flux * f * cos / (d^2 cos^3(c)
/// A).
std::optional<CameraConnection> PinholeCamera::connect(const dvec3& point) const {
  const auto film = project(point);
  if (!film) return std::nullopt;
  const dvec3 way = eye_ - point;
  const double distance2 = glm::dot(way, way);
  const double distance = std::sqrt(distance2);
  const dvec3 direction = way / distance;
  const double cos_c = -glm::dot(direction, forward_);
  const double area = pixel_angle_ * pixel_angle_;
  return CameraConnection{*film, direction, distance, distance2 * cos_c * cos_c * cos_c * area};
}

PinholeCamera place(const Pinhole&, const Camera& camera, const ImageScale& image) {
  return {camera, image.width, image.height};
}

Projection projection(const Pinhole&, const Camera& camera, const ImageScale& image) {
  return [pinhole = PinholeCamera(camera, image.width, image.height)](const dvec3& point) {
    return pinhole.project(point);
  };
}

double reach(const Pinhole&, double) {
  return 0.0;
}

} // namespace abbe
