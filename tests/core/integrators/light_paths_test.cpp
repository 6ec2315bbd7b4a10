#include "core/integrators/light_paths.h"
#include "tests/catch.h"
#include "tests/core/integrators/walk_scene.h"

#include <cmath>

using namespace abbe;
using test::WalkScene;

namespace {

/// Follows light paths without a camera and keeps their photons.
struct Paths {
  WalkScene s;
  Emission emission;
  Film film;
  LightPaths paths;
  PhotonBatch batch;

  explicit Paths(const std::string& text)
      : s(text + " light E 0 0 50 1"), film({0, 0, 1, 1}, 1.0, 0),
        paths(s.plan, s.world, emission, nullptr, film) {}

  /// A ray of the scene's light that carries a flux of 2 as one path of `share`.
  void trace(const dvec3& place, const dvec3& direction, std::uint32_t number = 0,
             double share = 1.0) {
    EmittedRay ray;
    ray.state = s.bundle_from(place, direction).state;
    ray.source = s.plan.light_source(0);
    ray.flux = 2.0;
    paths.trace(ray, Sampler(0, 0, number, 7), share, &batch, share, s.counts);
  }
};

const std::string kMirror = "reflectivity 0.5 fresnel off diffuse 0 0 0\n"
                            "push scale 9 9 1 square pop defaultMaterials\n";
const std::string kWall = "defaultMaterials push translate 0 0 1 scale 9 9 1 square pop ";

} // namespace

TEST_CASE("light that comes by a mirror leaves a photon where it is scattered") {
  Paths p(kMirror + kWall);
  p.trace({-0.5, 0, 0.5}, {1, 0, -1}, 0, 0.25);
  REQUIRE(p.batch.photons.size() == 1);
  const Photon& photon = p.batch.photons[0];
  CHECK(glm::distance(photon.position, dvec3(1.0, 0.0, 1.0)) < 1e-12);
  CHECK(glm::distance(photon.direction, glm::normalize(dvec3(1.0, 0.0, 1.0))) < 1e-12);
  CHECK(glm::distance(photon.normal, dvec3(0.0, 0.0, -1.0)) < 1e-12); // where it comes from
  CHECK(photon.source == p.s.plan.light_source(0));
  REQUIRE(p.batch.flux.size() == 81);
  for (const float flux : p.batch.flux)
    CHECK(flux == Approx(2.0 * 0.25 * 0.5)); // flux, share, reflectivity
  CHECK(p.s.counts.light == 1);
  CHECK(p.s.counts.reflected == 1);
  CHECK(p.s.counts.total() == 2);
  CHECK(p.s.counts.photons == 1);
}

TEST_CASE("light that comes straight from its light is left to camera paths") {
  Paths p(kMirror + kWall);
  p.trace({0, 0, 0.5}, {0, 0, 1});
  CHECK(p.batch.photons.empty());
  CHECK(p.s.counts.total() == 1);
}

TEST_CASE("a light path carries its light's bands and no others") {
  Paths p("lights " ABBE_SOURCE_DIR "/scenes/lights.filter light 2a 0 0 50 1\n" + kMirror + kWall);
  p.trace({-0.5, 0, 0.5}, {1, 0, -1}); // of filter 2a, which is dark at both ends
  REQUIRE(p.batch.photons.size() == 1);
  const SourcePlan& source = p.s.plan.sources[static_cast<std::size_t>(p.s.plan.light_source(0))];
  const Photon& photon = p.batch.photons[0];
  CHECK(photon.bands.first > 0);
  CHECK(source.factor[photon.bands.first - 1] == 0.0f);
  CHECK(source.factor[photon.bands.first] > 0.0f);
  CHECK(photon.bands.last < 81);
  CHECK(source.factor[photon.bands.last] == 0.0f);
}

TEST_CASE("paths end after as many surfaces as are asked for") {
  Paths p(kMirror + kWall + " maxRecursionDepth 1");
  p.trace({-0.5, 0, 0.5}, {1, 0, -1});
  CHECK(p.batch.photons.empty());
}

// A clear plate in normal light passes 2 n / (n^2 + 1) of it, all reflections to and fro included.
// Flux is not scaled by n^2 on the way, as radiance is.
TEST_CASE("through a plate of glass the mean flux is what Fresnel's equations let through") {
  Paths p("maxRecursionDepth 20 transparency 1 reflectivity 1 speedOfLight 1.5 diffuse 0 0 0\n"
          "push translate 0 0 3 scale 9 9 0.5 cube pop defaultMaterials "
          "push translate 0 0 -1 scale 9 9 1 square pop");
  constexpr int kPaths = 8192;
  for (int i = 0; i < kPaths; ++i)
    p.trace({0.1, 0.2, 6}, {0, 0, -1}, static_cast<std::uint32_t>(i), 0.5 / kPaths);
  double sum = 0.0;
  for (const Photon& photon : p.batch.photons)
    sum += static_cast<double>(p.batch.flux[photon.flux + 40]);
  const double expected = 2.0 * 1.5 / (1.5 * 1.5 + 1.0);
  CHECK(std::abs(sum - expected) < 4.0 * std::sqrt(expected * (1.0 - expected) / kPaths));
}
