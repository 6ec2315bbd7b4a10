#include "io/selftest/rainbow_rows.h"

#include "core/optics/fresnel.h"
#include "io/selftest/expected_index.h"
#include "io/selftest/single_ray.h"
#include "io/selftest/small_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace abbe {
namespace {

/// By how much a ray is turned that enters a drop at the incidence i, is thrown back inside k times
/// and leaves: k 180 + 2 i - 2 (k + 1) r degrees. It is least where cos^2 i = (n^2 - 1) / (k (k +
/// 2)), and there the bow stands [BW99, 4.7; Descartes]. Returned is the bow's radius around the
/// point opposite to the sun.
double descartes_deg(double n, int reflections) {
  const double k = reflections;
  const double i = std::acos(std::sqrt((n * n - 1.0) / (k * (k + 2.0))));
  const double r = std::asin(std::sin(i) / n);
  const double turned = k * 180.0 + (2.0 * i - 2.0 * (k + 1.0) * r) / kRadiansPerDegree;
  return reflections == 1 ? 180.0 - turned : turned - 180.0;
}

/// How far from the point opposite to the sun a ray goes on that meets a drop at this part of its
/// radius from the axis, from the sun along +z.
double seen_at_deg(const World& world, double height, double n, int reflections) {
  RayState state{{{height, 0.0, -5.0}, {0.0, 0.0, 1.0}}, {}, {}};
  auto hit = world.closest(state).value();
  state = refracted_at(hit, state.ray, 1.0, n);
  for (int i = 0; i < reflections; ++i) {
    hit = world.closest(state).value();
    state = hit.going_on(reflected(state.ray.direction, -hit.normal), false);
  }
  hit = world.closest(state).value();
  state = refracted_at(hit, state.ray, n, 1.0);
  return std::acos(std::clamp(-state.ray.direction.z, -1.0, 1.0)) / kRadiansPerDegree;
}

/// The largest such angle for the primary bow, the least for the secondary, by ternary search.
double bow_by_rays_deg(const World& world, double n, int reflections) {
  const double sign = reflections == 1 ? 1.0 : -1.0;
  const auto angle = [&](double h) { return sign * seen_at_deg(world, h, n, reflections); };
  double low = 0.7, high = 0.999;
  while (high - low > 1e-8) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    const bool left = angle(a) > angle(b);
    (left ? high : low) = left ? b : a;
  }
  return sign * angle(0.5 * (low + high));
}

constexpr int kPixels = 480;
constexpr double kMiddle_deg = 46.0, kView_deg = 20.0; // a pixel is about 0.04 degrees

/// A column of pixels across the bows, through rain, the sun at the horizon behind the camera.
Film column_of_rain(double index) {
  const double a = kMiddle_deg * kRadiansPerDegree;
  Rendering r = rendered(fmt::format(
      "unit m eye 0 0 0 lookAt 0 {} {} fieldOfView {} imageSize 1 {} samples 1 filter box "
      "light E 0 0 1 0 bands 3 drops 1e-6 dropSun 0 dropIndex {} push translate 0 0 -200 "
      "scale 1000 1000 100 cube pop",
      exact_text(std::sin(a)), exact_text(-std::cos(a)), kView_deg, kPixels, index));
  return std::move(r.film);
}

double brightest_deg(const Film& film, double from, double to) {
  double best = 0.0, best_deg = 0.0;
  for (int y = 0; y < kPixels; ++y) {
    const double up =
        (1.0 - (y + 0.5) * 2.0 / kPixels) * std::tan(0.5 * kView_deg * kRadiansPerDegree);
    const double radius = kMiddle_deg + std::atan(up) / kRadiansPerDegree;
    if (radius < from || radius > to || film.radiance(0, y, 1) <= best) continue;
    best = film.radiance(0, y, 1);
    best_deg = radius;
  }
  return best_deg;
}

} // namespace

SelftestRows rainbow_rows() {
  SelftestRows rows;
  const World ball({{Sphere{}, Transform(), MaterialId{0}, MediumId{0}, 0}}, 10.0);
  const auto water = expected_index("water-20C");
  constexpr const char* kNames[] = {"F", "d", "C"};
  for (const int reflections : {1, 2})
    for (std::size_t line = 0; line < kGlassLines_nm.size(); ++line)
      rows.push_back(
          {"rainbow",
           fmt::format("{} bow of water at {}", reflections == 1 ? "primary" : "secondary",
                       kNames[line]),
           "Descartes", descartes_deg(water[line], reflections),
           bow_by_rays_deg(ball, catalogue_index("water-20C", kGlassLines_nm[line]), reflections),
           1e-4, "deg"});
  for (const double n : {1.3311, 1.3435}) {
    const Film film = column_of_rain(n);
    rows.push_back({"rainbow", fmt::format("picture of rain, n = {}, primary", n), "Descartes",
                    descartes_deg(n, 1), brightest_deg(film, 38.0, 46.0), 0.1, "deg"});
    rows.push_back({"rainbow", fmt::format("picture of rain, n = {}, secondary", n), "Descartes",
                    descartes_deg(n, 2), brightest_deg(film, 46.0, 55.0), 0.1, "deg"});
  }
  return rows;
}

} // namespace abbe
