#include "core/integrators/light_paths.h"
#include "core/materials/fresnel.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

// Newton's experiment: a narrow beam through a prism of SF11 falls on a wall. Where each band lands
// and how much of it arrives is known from Snell's and Fresnel's laws for the beam's axis.

namespace {

using glm::dvec2;

constexpr double kWall = 5.5;
const dvec2 kLamp{-4.6654423, -1.8996736};
const dvec2 kAxis = glm::normalize(dvec2(4.1654423, 2.765699));

const char* const kScene = "integrator path\n"
                           "falloff square\n"
                           "spotlight E -4.6654423 -1.8996736 0 1  4.1654423 2.765699 0  0.02\n"
                           "glass SF11\n"
                           "polyhedron vertices 6  -1 0 1  1 0 1  0 1.7320508 1\n"
                           "                       -1 0 -1  0 1.7320508 -1  1 0 -1\n"
                           "defaultMaterials diffuse 0.78 0.78 0.78\n"
                           "translate 5.5 -2 0 rotate -90 0 1 0 scale 9 9 1 square\n";

struct Arrival {
  double y;             ///< on the wall
  double transmittance; ///< of the two faces
};

/// The axis of the beam, in the plane of the prism's section.
Arrival exact(double n) {
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
  return {p.y + d.y * (kWall - p.x) / d.x, passed};
}

} // namespace

TEST_CASE("each band of Newton's spectrum lands where Snell sends it, with what Fresnel leaves") {
  const Scene scene = test::scene_from(kScene);
  RenderSettings settings = scene.settings;
  settings.jitter = false;
  const Plan plan = make_plan(scene, settings);
  REQUIRE(plan.caustics);
  const World world(scene.shapes, farthest_coordinate(scene));
  Emission emission(scene, plan);
  emission.place(world);
  REQUIRE(emission.emitters().size() == 1);
  Film film({0, 0, 1, 1}, 1.0, 0);
  LightPaths paths(plan, world, emission, nullptr, film);
  PhotonBatch batch;
  RayCounts counts;
  constexpr std::uint32_t kPaths = 1u << 17;
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    const Sampler sampler(0, 0, i, 7);
    if (const auto ray = emission.emitters()[0].sample(sampler))
      paths.trace(*ray, sampler, 1.0 / kPaths, &batch, 1.0 / kPaths, counts);
  }
  const double half_angle = 0.02 * 3.14159265358979 / 180.0;
  const double beam = 3.14159265358979 * half_angle * half_angle; // flux per unit of spectrum
  for (int b = 0; b < 81; ++b) {
    const double nm = 380.0 + 5.0 * b;
    const Arrival arrival = exact(refractive_index(find_glass("SF11")->dispersion, nm));
    double flux = 0.0, moment = 0.0;
    for (const Photon& photon : batch.photons) {
      if (b < photon.first || b >= photon.last) continue;
      if (std::abs(photon.position.x - kWall) > 1e-9) continue;
      if (std::abs(photon.position.y - arrival.y) > 0.03) continue;
      const auto value =
          static_cast<double>(batch.flux[photon.flux + static_cast<std::size_t>(b - photon.first)]);
      flux += value;
      moment += value * photon.position.y;
    }
    INFO(nm << " nm");
    // The beam is 0.007 wide there, and each band has a tenth of the paths: some 3000 photons.
    CHECK(moment / flux == Approx(arrival.y).margin(2e-4));
    CHECK(flux == Approx(beam * arrival.transmittance).epsilon(0.02));
  }
}
