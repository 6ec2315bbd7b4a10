#include "core/integrators/photon_map.h"
#include "tests/catch.h"

#include <numbers>
#include <random>
#include <set>

using namespace abbe;

namespace {

constexpr double kRadius = 0.07;

/// Photons on the plane z = 0, from above; the flux of each is its number.
PhotonBatch scattered(int count, int seed, std::size_t first_number) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  PhotonBatch batch;
  for (int i = 0; i < count; ++i) {
    Photon photon;
    photon.position = {unit(random), unit(random), 0.0};
    photon.direction = {0.0, 0.0, -1.0};
    photon.normal = {0.0, 0.0, 1.0};
    const auto number = static_cast<float>(first_number + static_cast<std::size_t>(i));
    const float flux[] = {0.0f, 0.0f, 0.0f, number, 2.0f * number};
    batch.add(photon, {flux, {3, 5}}, 1.0);
  }
  return batch;
}

Hit at(const dvec3& point, bool entering = true) {
  Hit hit;
  hit.point = point;
  hit.normal = {0.0, 0.0, 1.0};
  hit.entering = entering;
  return hit;
}

} // namespace

TEST_CASE("photons are found once each, and all of them") {
  PhotonBatch batches[] = {scattered(3000, 1, 0), scattered(2000, 2, 3000)};
  PhotonMap map(true);
  map.build(batches, kRadius);
  CHECK(map.size() == 5000);
  CHECK(map.density_factor() == Approx(1.0 / (std::numbers::pi * kRadius * kRadius)));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const dvec3 place{unit(random), unit(random), 0.0};
    std::multiset<float> found, expected;
    map.for_each_near(at(place), false, [&](const Photon& photon, const float* flux) {
      CHECK(flux[1] == 2.0f * flux[0]);
      CHECK(glm::distance(photon.position, place) < kRadius);
      found.insert(flux[0]);
    });
    for (const PhotonBatch& batch : batches)
      for (const Photon& photon : batch.photons)
        if (glm::distance(photon.position, place) < kRadius)
          expected.insert(batch.flux[photon.flux]);
    CHECK(found == expected);
  }
}

TEST_CASE("light on the other side, or on a wall nearby, does not count") {
  PhotonBatch batches[] = {scattered(3000, 1, 0)};
  PhotonMap map(true);
  map.build(batches, kRadius);
  const auto count = [&](const Hit& hit, bool both_sides = false) {
    int n = 0;
    map.for_each_near(hit, both_sides, [&](const Photon&, const float*) { ++n; });
    return n;
  };
  CHECK(count(at({0.0, 0.0, 0.0})) > 0);
  CHECK(count(at({0.0, 0.0, 0.0}, false)) == 0);
  CHECK(count(at({0.0, 0.0, 0.0}, false), true) == count(at({0.0, 0.0, 0.0})));
  CHECK(count(at({0.0, 0.0, 0.5 * kRadius})) == 0);
  Hit wall = at({0.0, 0.0, 0.0});
  wall.normal = {1.0, 0.0, 0.0};
  CHECK(count(wall) == 0);
  CHECK(count(wall, true) == 0);
}

TEST_CASE("an empty map has nothing near") {
  PhotonMap map(true);
  map.build({}, kRadius);
  map.for_each_near(at(dvec3(0.0)), false, [](const Photon&, const float*) { FAIL(); });
}
