#include "core/emitters/sampled_surface.h"
#include "core/integrators/photon_map.h"
#include "tests/catch.h"

#include <cmath>
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

constexpr ShapeId kFloor{0}, kSheet{1};

/// The numbers of the photons found near a hit.
std::multiset<float> near(const PhotonMap& map, const Hit& hit) {
  std::multiset<float> found;
  map.for_each_near(hit, false, [&](const Photon&, const float* flux) { found.insert(flux[0]); });
  return found;
}

/// The numbers of those within the radius, on whatever surface.
std::multiset<float> within_radius(std::span<const PhotonBatch> batches, const dvec3& place) {
  std::multiset<float> expected;
  for (const PhotonBatch& batch : batches)
    for (const Photon& photon : batch.photons)
      if (glm::distance(photon.position, place) < kRadius) expected.insert(batch.flux[photon.flux]);
  return expected;
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

TEST_CASE("light on a sheet does not count on the floor below it, nor the other way round") {
  for (const ShapeId on : {kFloor, kSheet}) {
    PhotonBatch batches[] = {scattered(3000, 1, 0)};
    for (Photon& photon : batches[0].photons)
      photon.shape = on;
    PhotonMap map(true);
    map.build(batches, kRadius);
    for (const double gap : {0.2, 0.01, 0.002}) {
      Hit below = at({0.0, 0.0, -gap * kRadius}), above = at({0.0, 0.0, gap * kRadius});
      below.shape = above.shape = kFloor;
      CHECK(near(map, below).empty());
      CHECK(near(map, above).empty());
    }
  }
}

TEST_CASE("light counts across the seam of two squares that touch") {
  PhotonBatch batches[] = {scattered(3000, 1, 0)};
  for (Photon& photon : batches[0].photons)
    photon.shape = photon.position.x < 0.0 ? kFloor : kSheet;
  PhotonMap map(true);
  map.build(batches, kRadius);
  for (const double x : {-0.9 * kRadius, -0.01, 0.0, 0.01, 0.9 * kRadius}) {
    Hit hit = at({x, 0.1, 0.0});
    hit.shape = x < 0.0 ? kFloor : kSheet;
    CHECK(near(map, hit) == within_radius(batches, hit.point));
    CHECK(near(map, hit).size() > 4);
  }
}

TEST_CASE("light on one leaf of a fold does not count on the other") {
  // Both leaves belong to one mesh and part from the crease x = 0 at a small angle.
  constexpr double kAngle = 0.02;
  PhotonBatch batches[] = {scattered(6000, 1, 0)};
  for (Photon& photon : batches[0].photons) {
    photon.position.z = kAngle * (photon.position.x = std::abs(photon.position.x));
    photon.normal = glm::normalize(dvec3{-kAngle, 0.0, 1.0});
    photon.shape = kFloor;
  }
  PhotonMap map(true);
  map.build(batches, kRadius);
  for (const double x : {1.0, 1.5, 3.0}) {
    Hit hit = at({x * kRadius, 0.0, 0.0}); // what is nearer to the crease sees beyond it
    hit.shape = kFloor;
    CHECK(within_radius(batches, hit.point).size() > 4);
    CHECK(near(map, hit).empty());
  }
  // Where the mesh goes on beyond the crease instead, all of them count.
  Hit beyond = at({-0.5 * kRadius, 0.0, 0.0});
  beyond.shape = kFloor;
  CHECK(near(map, beyond) == within_radius(batches, beyond.point));
}

TEST_CASE("light on a ball counts within the radius, however small the ball") {
  // A sphere of chord r about a place on a ball cuts off a cap of area pi r^2 (Archimedes).
  for (const double size : {1.0, 0.2, 0.1}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    PhotonBatch batches[1];
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
      Photon photon;
      photon.normal = sphere_point({unit(random), unit(random)});
      photon.position = size * photon.normal;
      photon.shape = kFloor;
      const auto number = static_cast<float>(i);
      batches[0].add(photon, {&number, {0, 1}}, 1.0);
    }
    PhotonMap map(true);
    map.build(batches, kRadius / 2);
    double found = 0.0;
    constexpr int kPlaces = 200;
    for (int i = 0; i < kPlaces; ++i) {
      Hit hit;
      hit.normal = sphere_point({unit(random), unit(random)});
      hit.point = size * hit.normal;
      hit.shape = kFloor;
      found += static_cast<double>(near(map, hit).size()) / kPlaces;
    }
    const double expected = kCount * 0.25 * kRadius * kRadius / (4.0 * size * size);
    CHECK(found == Approx(expected).epsilon(6.0 / std::sqrt(kPlaces * expected)));
  }
}
