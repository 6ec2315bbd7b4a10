#include "io/building/studio.h"

#include "spectral/illuminant.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// A soft box as seen from the scene: a rectangle in longitude and latitude, in degrees. Longitude
/// 0 is the front, from which the fitted camera looks, and 90 its right.
struct SoftBox {
  double longitude, latitude, half_width, half_height, radiance;
};
constexpr std::array<SoftBox, 3> kSoftBoxes{{
    {-40.0, 45.0, 22.0, 16.0, 14.0}, // key
    {65.0, 20.0, 14.0, 25.0, 4.0},   // fill
    {160.0, 35.0, 25.0, 12.0, 8.0},  // rim, from behind
}};

double studio_radiance(double longitude, double latitude) {
  for (const SoftBox& box : kSoftBoxes)
    if (std::abs(std::remainder(longitude - box.longitude, 360.0)) <= box.half_width &&
        std::abs(latitude - box.latitude) <= box.half_height)
      return box.radiance;
  return 0.25 + 0.15 * std::sin(latitude * std::numbers::pi / 180.0);
}

} // namespace

void fit_camera(Scene& scene) {
  Bounds all;
  for (const PlacedShape& shape : scene.shapes)
    if (is_bounded(shape.shape)) all = all.joined(bounds(shape));
  Camera& camera = scene.camera;
  camera.look_at = all.empty() ? dvec3(0.0) : 0.5 * (all.lower + all.upper);
  const double extent = all.empty() ? 2.0 : glm::length(all.upper - all.lower);
  const double radius = extent > 0.0 ? 0.5 * extent : 1.0;
  // The smaller of the two fields of view must hold the ball around all shapes.
  const double up = std::tan(camera.field_of_view_deg * std::numbers::pi / 360.0);
  const double across = up * scene.settings.width / scene.settings.height;
  const double distance = radius / std::sin(std::atan(std::min(up, across)));
  camera.eye = camera.look_at + distance * glm::normalize(dvec3(0.5, 0.35, 1.0));
  camera.up = {0.0, 1.0, 0.0};
}

void add_studio_light(Scene& scene) {
  Environment studio;
  studio.width = 360;
  studio.height = 180;
  studio.light = *find_illuminant("D65");
  studio.has_colors = false;
  for (int y = 0; y < studio.height; ++y)
    for (int x = 0; x < studio.width; ++x) {
      // The middle of an environment is the view along -z, which is behind the scene.
      const double longitude = 180.0 - (x + 0.5);
      const double latitude = 90.0 - (y + 0.5);
      const auto radiance = static_cast<float>(studio_radiance(longitude, latitude));
      studio.rgb.insert(studio.rgb.end(), 3, radiance);
    }
  scene.environment = std::move(studio);
}

} // namespace abbe
