#include "io/preview/preview_camera.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// The vector, turned about an axis of unit length. (Rodrigues' formula)
dvec3 turned(const dvec3& v, const dvec3& axis, double angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * glm::dot(axis, v) * (1.0 - std::cos(angle));
}

void open_lens(Camera& camera, const PreviewWishes& wishes) {
  if (wishes.aperture) {
    if (auto* lens = std::get_if<RealLens>(&camera.kind))
      lens->aperture = *wishes.aperture;
    else if (*wishes.aperture > 0.0) {
      ThinLens thin{*wishes.aperture};
      if (const auto* old = std::get_if<ThinLens>(&camera.kind))
        thin.focus_distance = old->focus_distance;
      camera.kind = thin;
    } else
      camera.kind = Pinhole{};
  }
  if (!wishes.focus_distance) return;
  if (auto* thin = std::get_if<ThinLens>(&camera.kind))
    thin->focus_distance = wishes.focus_distance;
  if (auto* lens = std::get_if<RealLens>(&camera.kind)) {
    lens->focus_distance = wishes.focus_distance;
    lens->film_distance_mm = std::nullopt;
  }
}

std::string distance_line(const std::optional<double>& distance) {
  if (!distance) return "";
  return std::isinf(*distance) ? "focusDistance inf\n"
                               : fmt::format("focusDistance {}\n", *distance);
}

} // namespace

Camera wished_camera(Camera camera, const PreviewWishes& wishes) {
  const dvec3 up = glm::normalize(camera.up);
  dvec3 back = camera.eye - camera.look_at;
  back = turned(back, up, -wishes.orbit.x);
  const dvec3 right = glm::normalize(glm::cross(up, back));
  // Not over the poles, where nothing tells what is up.
  const double height = std::asin(std::clamp(glm::dot(glm::normalize(back), up), -1.0, 1.0));
  constexpr double kMost = 0.49 * std::numbers::pi;
  const double next = std::clamp(height + wishes.orbit.y, -kMost, kMost);
  if (wishes.orbit.y != 0.0) back = turned(back, right, height - next);
  if (wishes.orbit != glm::dvec2(0.0) || wishes.distance != 1.0)
    camera.eye = camera.look_at + wishes.distance * back;
  open_lens(camera, wishes);
  return camera;
}

std::optional<double> distance_at(const World& world, const Camera& camera,
                                  double width_over_height, const glm::dvec2& at) {
  const dvec3 forward = glm::normalize(camera.look_at - camera.eye);
  const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const dvec3 down = glm::cross(forward, right);
  const double half = std::tan(camera.field_of_view_deg * std::numbers::pi / 360.0);
  const dvec3 direction =
      glm::normalize(forward + (2.0 * at.x - 1.0) * half * width_over_height * right +
                     (2.0 * at.y - 1.0) * half * down);
  const auto hit = world.closest(world.start_at({camera.eye, direction}));
  if (!hit) return std::nullopt;
  return hit->t * glm::dot(direction, forward);
}

std::string camera_lines(const Camera& camera) {
  const auto line = [](const char* keyword, const dvec3& v) {
    return fmt::format("{} {} {} {}\n", keyword, v.x, v.y, v.z);
  };
  std::string lines = line("eye", camera.eye) + line("lookAt", camera.look_at) +
                      line("up", camera.up) +
                      fmt::format("fieldOfView {}\n", camera.field_of_view_deg);
  if (const auto* thin = std::get_if<ThinLens>(&camera.kind))
    lines += fmt::format("aperture {}\n", thin->aperture) + distance_line(thin->focus_distance);
  if (const auto* lens = std::get_if<RealLens>(&camera.kind)) {
    if (lens->aperture > 0.0) lines += fmt::format("aperture {}\n", lens->aperture);
    lines += distance_line(lens->focus_distance);
  }
  return lines;
}

} // namespace abbe
