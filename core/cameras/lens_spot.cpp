#include "core/cameras/lens_spot.h"

#include <cmath>
#include <numbers>

namespace abbe {

std::optional<LensSpot> lens_spot(const LensSystem& lens, double lambda_nm, double field_deg,
                                  double film_distance) {
  const double angle = field_deg * std::numbers::pi / 180.0;
  const dvec3 direction(0.0, std::sin(angle), std::cos(angle));
  const double radius = lens.surfaces().front().semi_diameter;
  const double film = lens.last_vertex() + film_distance;
  const std::vector<double> n = lens.indices(lambda_nm);
  constexpr int kAcross = 128; // about 12900 rays within the circle
  double x_squares = 0.0, y_sum = 0.0, y_squares = 0.0;
  int rays = 0;
  for (int i = 0; i < kAcross; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const double x = radius * ((2.0 * i + 1.0) / kAcross - 1.0);
      const double y = radius * ((2.0 * j + 1.0) / kAcross - 1.0);
      if (std::hypot(x, y) > radius) continue;
      // The ray begins before all of the first surface and aims at this place in the plane of its
      // vertex.
      const dvec3 origin = dvec3(x, y, 0.0) - direction * (2.0 * radius / direction.z);
      const auto through = lens.trace_from_object({origin, direction}, n);
      if (!through) continue;
      const Ray& ray = through->ray;
      const dvec3 at = ray.at((film - ray.origin.z) / ray.direction.z);
      ++rays;
      x_squares += at.x * at.x;
      y_sum += at.y;
      y_squares += at.y * at.y;
    }
  if (rays == 0) return std::nullopt;
  // The light is symmetric to x = 0, so that its middle lies there.
  const double middle = y_sum / rays;
  const double variance = (x_squares + y_squares) / rays - middle * middle;
  return LensSpot{middle, std::sqrt(std::fmax(variance, 0.0)), rays};
}

} // namespace abbe
