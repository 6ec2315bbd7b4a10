#include "core/planning/plan_camera.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <variant>

namespace abbe {
namespace {

Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 c{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k)
        c[i][j] += a[i][k] * b[k][j];
  return c;
}

} // namespace

CameraMatrices camera_matrices(const Camera& camera, int width, int height) {
  const dvec3 forward = glm::normalize(camera.look_at - camera.eye);
  const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const dvec3 up = glm::cross(right, forward);
  CameraMatrices matrices{};
  Matrix4& to_camera = matrices.world_to_camera;
  for (int i = 0; i < 3; ++i)
    to_camera[static_cast<std::size_t>(i)] = {right[i], up[i], forward[i], 0.0};
  to_camera[3] = {-glm::dot(right, camera.eye), -glm::dot(up, camera.eye),
                  -glm::dot(forward, camera.eye), 1.0};
  if (std::holds_alternative<RealLens>(camera.kind)) return matrices;
  // A point at depth 1 and at half the height of the view is at the image's upper edge.
  const double y = 0.5 / std::tan(camera.field_of_view_deg * std::numbers::pi / 360.0);
  const double x = y * height / width;
  const Matrix4 to_image{{{x, 0, 0, 0}, {0, -y, 0, 0}, {0.5, 0.5, 1, 1}, {0, 0, 0, 0}}};
  matrices.world_to_image = product(to_camera, to_image);
  return matrices;
}

} // namespace abbe
