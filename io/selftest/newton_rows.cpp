#include "io/selftest/newton_rows.h"

#include "core/integrators/light_paths.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "io/selftest/expected_index.h"
#include "io/selftest/single_ray.h"
#include "io/selftest/small_picture.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace abbe {
namespace {

const dvec2 kLamp{-4.6654423, -1.8996736};
const dvec2 kAxis = glm::normalize(dvec2(4.1654423, 2.765699));
constexpr double kHalfAngle_deg = 0.02;

} // namespace

std::string newton_scene() {
  return "integrator path\n"
         "falloff square\n"
         "spotlight E -4.6654423 -1.8996736 0 1  4.1654423 2.765699 0  0.02\n"
         "glass SF11\n"
         "polyhedron vertices 6  -1 0 1  1 0 1  0 1.7320508 1\n"
         "                       -1 0 -1  0 1.7320508 -1  1 0 -1\n"
         "defaultMaterials diffuse 0.78 0.78 0.78\n"
         "translate 5.5 -2 0 rotate -90 0 1 0 scale 9 9 1 square\n";
}

double newton_beam() {
  return std::numbers::pi * std::pow(kHalfAngle_deg * kRadiansPerDegree, 2);
}

NewtonArrival newton_arrival(double n) {
  const auto face = [](const dvec2& a, const dvec2& b) {
    const dvec2 along = glm::normalize(b - a);
    return std::pair(a, dvec2(along.y, -along.x)); // a point, and a normal
  };
  const dvec2 left(-1.0, 0.0), right(1.0, 0.0), top(0.0, 1.7320508);
  dvec2 p = kLamp, d = kAxis;
  double passed = 1.0;
  const auto cross = [&](const dvec2& a, const dvec2& b, double eta) {
    auto [point, normal] = face(a, b);
    if (glm::dot(normal, d) > 0.0) normal = -normal;
    p += d * (glm::dot(point - p, normal) / glm::dot(d, normal));
    const double cos_i = -glm::dot(d, normal);
    const double cos_t = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (eta * eta));
    const double rs = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double rp = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    passed *= 1.0 - 0.5 * (rs * rs + rp * rp);
    d = d / eta + (cos_i / eta - cos_t) * normal;
  };
  cross(left, top, n);
  cross(top, right, 1.0 / n);
  return {p.y + d.y * (kNewtonWall - p.x) / d.x, passed};
}

std::vector<NewtonBand> newton_wall(std::uint32_t paths) {
  const Scene scene = scene_of_text(newton_scene());
  RenderSettings settings = scene.settings;
  settings.jitter = false;
  settings.max_fan = 32;
  const Plan plan = make_plan(scene, settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  Emission emission(scene, plan);
  emission.place(world);
  Film film({0, 0, 1, 1}, 1.0, 0);
  LightPaths light_paths(plan, world, emission, nullptr, film);
  PhotonBatch batch;
  RayCounts counts;
  for (std::uint32_t i = 0; i < paths; ++i) {
    const Sampler sampler(0, 0, i, 7);
    if (const auto ray = emission.lights().at(0).sample(sampler))
      light_paths.trace(*ray, sampler, 1.0 / paths, &batch, 1.0 / paths, counts);
  }
  std::vector<NewtonBand> wall(kSampleCount);
  for (int b = 0; b < kSampleCount; ++b) {
    const NewtonArrival arrival = newton_arrival(catalogue_index("SF11", sample_nm(b)));
    NewtonBand& band = wall[static_cast<std::size_t>(b)];
    for (const Photon& photon : batch.photons) {
      if (b < photon.bands.first || b >= photon.bands.last) continue;
      if (std::abs(photon.position.x - kNewtonWall) > 1e-9) continue;
      if (std::abs(photon.position.y - arrival.y) > 0.03) continue;
      const auto value = static_cast<double>(
          batch.flux[photon.flux + static_cast<std::size_t>(b - photon.bands.first)]);
      band.flux += value;
      band.y += value * photon.position.y;
    }
    band.y /= band.flux;
  }
  return wall;
}

SelftestRows newton_rows() {
  // n of SF11 at the middles of bands, by a script outside this program from Schott's formula.
  constexpr std::pair<int, double> kIndices[] = {
      {400, 1.845121460}, {450, 1.819053819}, {500, 1.802509071}, {550, 1.791137957},
      {600, 1.782889487}, {650, 1.776661808}, {700, 1.771808976}};
  const std::vector<NewtonBand> wall = newton_wall(1u << 16);
  SelftestRows rows;
  for (const auto& [nm, n] : kIndices) {
    const NewtonBand& band = wall.at(static_cast<std::size_t>((nm - 380) / 5));
    const NewtonArrival expected = newton_arrival(n);
    rows.push_back({"Newton", fmt::format("{} nm on the wall, height", nm), "Snell's law",
                    expected.y, band.y, 3e-4});
    rows.push_back({"Newton", fmt::format("{} nm on the wall, part of the beam", nm),
                    "Fresnel's equations", expected.transmittance, band.flux / newton_beam(),
                    0.02});
  }
  return rows;
}

} // namespace abbe
