#include "core/lights/light_hierarchy.h"

#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <vector>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi;

/// A light that shines within an angle of an axis.
struct Emitter {
  LightReach reach;
  dvec3 axis;
  double angle;
};

/// Draws lights and places.
class Draw {
public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double number(double from, double to) {
    return from + (to - from) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  dvec3 point(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }
  dvec3 direction() {
    dvec3 v(0.0);
    do
      v = point(1.0);
    while (!(glm::length(v) > 0.1 && glm::length(v) < 1.0));
    return glm::normalize(v);
  }
  /// A spot, a panel of one side, a ball, or parallel light.
  Emitter light() {
    const double kind = number(0.0, 4.0), strength = std::exp(number(-5.0, 3.0));
    if (kind > 3.7) return {LightReach::distant(number(0.0, 1.0)), {}, kPi};
    const dvec3 centre = point(5.0), axis = direction();
    const Bounds box{centre, centre};
    if (kind < 1.0) {
      const double angle = number(0.05, 1.4);
      return {LightReach(box, strength, 0.0).along(axis, angle, 0.0), axis, angle};
    }
    if (kind < 2.0)
      return {LightReach(box.grown(number(0.0, 1.0)), strength, 0.0).along(axis, 0.0, 0.5 * kPi),
              axis, 0.5 * kPi};
    return {LightReach(box.grown(number(0.0, 0.3)), strength, 0.0), axis, kPi};
  }

private:
  std::mt19937_64 engine_;
};

LightReach point_at(const dvec3& place, double intensity) {
  return {{place, place}, intensity, 0.0};
}

} // namespace

// Irradiances from distances 1, 2 and 3 are 1, 1 and 1/9; parallel light of 8/9 makes them 3.
TEST_CASE("lights are chosen by the irradiance that they can give") {
  const LightReach near = point_at({1, 0, 0}, 1.0), far = point_at({0, 0, -3}, 1.0);
  const LightHierarchy two(std::vector<LightReach>{near, far});
  CHECK(two.chance(0, {0, 0, 0}) == Approx(0.9));
  CHECK(two.chance(1, {0, 0, 0}) == Approx(0.1));
  const LightHierarchy all(
      std::vector<LightReach>{near, LightReach::distant(8.0 / 9.0), point_at({0, 2, 0}, 4.0), far});
  CHECK(all.chance(0, {0, 0, 0}) == Approx(1.0 / 3.0));
  CHECK(all.chance(1, {0, 0, 0}) == Approx(8.0 / 27.0));
  CHECK(all.chance(2, {0, 0, 0}) == Approx(1.0 / 3.0));
  CHECK(all.chance(3, {0, 0, 0}) == Approx(1.0 / 27.0));
}

TEST_CASE("a spot that shines another way is not chosen") {
  const LightReach spot = point_at({0, 0, 5}, 100.0).along({0, 0, -1}, kPi / 6.0, 0.0);
  const LightHierarchy lights(std::vector<LightReach>{spot, point_at({9, 0, 0}, 0.001)});
  CHECK(lights.chance(0, {0, 0, 0}) > 0.99);
  CHECK(lights.chance(0, {2.8, 0, 0}) > 0.99);
  CHECK(lights.chance(0, {2.9, 0, 0}) == 0.0);
  CHECK(lights.chance(1, {2.9, 0, 0}) == 1.0);
  CHECK(lights.chance(0, {0, 0, 6}) == 0.0);
  // Alone it leaves the place without any choice.
  CHECK_FALSE(LightHierarchy(std::vector<LightReach>{spot}).choose({0, 0, 6}, 0.5));
  CHECK_FALSE(LightHierarchy().choose({0, 0, 0}, 0.5));
}

TEST_CASE("the chances of a choice are those claimed, and add up to one") {
  Draw draw(5);
  for (const int count : {1, 2, 7, 300}) {
    std::vector<LightReach> reaches;
    for (int i = 0; i < count; ++i)
      reaches.push_back(draw.light().reach);
    const LightHierarchy lights(reaches);
    for (int round = 0; round < 20; ++round) {
      const dvec3 place = draw.point(6.0);
      double sum = 0.0;
      for (int i = 0; i < count; ++i)
        sum += lights.chance(i, place);
      if (!lights.choose(place, 0.5)) continue;
      CHECK(sum <= 1.0 + 1e-12); // less where a node's bound is not 0 but those of its halves are
      int nothing = 0;
      std::map<int, int> counts;
      constexpr int kDraws = 4000;
      for (int i = 0; i < kDraws; ++i) {
        const auto chosen = lights.choose(place, (i + 0.5) / kDraws);
        if (!chosen) {
          ++nothing;
          continue;
        }
        CHECK(chosen->chance == Approx(lights.chance(chosen->light, place)).epsilon(1e-10));
        ++counts[chosen->light];
      }
      CHECK(std::abs(nothing - kDraws * (1.0 - sum)) < 40.0);
      // Equally spaced numbers fall into an interval by its length, but for one at each end.
      for (const auto& [light, number] : counts)
        CHECK(std::abs(number - kDraws * lights.chance(light, place)) <= 1.001);
    }
  }
}

// The light of a spot or a panel goes from a point of it along a direction: that place is lit.
TEST_CASE("no light is left out where it arrives") {
  Draw draw(11);
  std::vector<Emitter> emitters;
  std::vector<LightReach> reaches;
  for (int i = 0; i < 500; ++i) {
    emitters.push_back(draw.light());
    reaches.push_back(emitters.back().reach);
  }
  const LightHierarchy lights(reaches);
  for (int i = 0; i < 500; ++i) {
    const Emitter& light = emitters[static_cast<std::size_t>(i)];
    for (int ray = 0; ray < 40; ++ray) {
      const dvec3 direction = draw.direction();
      const Bounds& box = light.reach.box();
      dvec3 place = draw.point(6.0);
      if (!light.reach.is_distant()) {
        if (std::acos(glm::dot(direction, light.axis)) >= light.angle) continue;
        place = box.lower + (box.upper - box.lower) * (0.5 + 0.5 * draw.point(1.0)) +
                std::exp(draw.number(-3.0, 3.0)) * direction;
      }
      CHECK(lights.chance(i, place) > 0.0);
    }
  }
}

TEST_CASE("lights at one place have their own chances") {
  std::vector<LightReach> lights(64, point_at({1, 2, 3}, 1.0));
  lights[9] = point_at({1, 2, 3}, 37.0);
  const LightHierarchy hierarchy(lights);
  CHECK(hierarchy.chance(9, {0, 0, 0}) == Approx(0.37));
  CHECK(hierarchy.chance(0, {0, 0, 0}) == Approx(0.01));
  CHECK(hierarchy.chance(63, {1, 2, 3}) == Approx(0.01));
}
