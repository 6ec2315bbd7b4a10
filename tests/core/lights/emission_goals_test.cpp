#include "core/lights/emission_goals.h"

#include "tests/catch.h"
#include "tests/core/emitters/direction_sampling.h"
#include "tests/core/lights/goals.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace abbe;

namespace {

using std::numbers::pi;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("one of several is chosen, and the number is uniform over [0, 1) again") {
  for (const double inside : {0.0, 0.25, 0.75})
    for (std::size_t i = 0; i < 4; ++i) {
      double u = (static_cast<double>(i) + inside) / 4.0;
      CHECK(one_of(4, u) == i);
      CHECK(u == inside);
    }
  double last = 1.0 - 0x1p-53;
  CHECK(one_of(3, last) == 2);
  CHECK(last < 1.0);
}

TEST_CASE("solid angles of targets add up, to all directions at most") {
  const double half = 2.0 * pi * (1.0 - std::sqrt(0.75)); // sin = 1/2
  CHECK(solid_angles({{{0, 0, 2}, 1.0}, {{0, 4, 0}, 2.0}}, dvec3(0.0)) ==
        Approx(2.0 * half).epsilon(1e-14));
  CHECK(solid_angles({{{0, 0, 2}, 1.0}, {dvec3(0.0), kInfinite}}, dvec3(0.0)) == 4.0 * pi);
}

TEST_CASE("directions towards overlapping targets come with the pdf that is claimed") {
  const std::vector<EmissionTarget> targets{{{0, 0, 3}, 1.0}, {{0.8, 0, 3}, 1.2}, {{0, 2, 1}, 0.5}};
  const dvec3 place(0.1, -0.2, 0.0);
  const Cone all{{0, 0, 1}, 2.0};
  // Each target is chosen as often as any other; a direction may be towards several.
  const auto pdf = [&](const dvec3& v) {
    double sum = 0.0;
    for (const EmissionTarget& t : targets) {
      const dvec3 to = t.center - place;
      const double squared_sine = t.radius * t.radius / glm::dot(to, to);
      if (glm::dot(v, glm::normalize(to)) > std::sqrt(1.0 - squared_sine))
        sum += 1.0 / (2.0 * pi * (1.0 - std::sqrt(1.0 - squared_sine))) / 3.0;
    }
    return sum;
  };
  const auto check = test::check_sampling(
      all,
      [&](const dvec2& u) {
        const DirectionSample drawn = towards(targets, place, u);
        CHECK(drawn.pdf == Approx(pdf(drawn.direction)).epsilon(1e-9));
        return std::optional(drawn.direction);
      },
      pdf, 20000, 96);
  CHECK(check.agrees());
}

// A line of light through two discs that overlap: the pdf is the mean of those of the discs it
// goes through.
TEST_CASE("lines of parallel light go through the discs with the pdf that is claimed") {
  const std::vector<EmissionTarget> balls{{{0, 0, 5}, 1.0}, {{1.5, 0, -5}, 2.0}};
  const EmissionGoals goals = test::goals(balls);
  const dvec3 down(0, 0, -1);
  CHECK(goals.parallel->area() == Approx(5.0 * pi).epsilon(1e-14));
  int both = 0, only_first = 0;
  double area = 0.0; // of the union: the mean of 1 / pdf
  constexpr std::uint32_t kCount = 1 << 14;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const ParallelSample line = goals.parallel->sample(down, Sampler(0, 0, i, 1).pair(0));
    CHECK(line.place.z > 100.0);
    double pdf = 0.0;
    bool in[2];
    for (std::size_t k = 0; k < 2; ++k) {
      in[k] = std::hypot(line.place.x - balls[k].center.x, line.place.y) < balls[k].radius;
      if (in[k]) pdf += 0.5 / (pi * balls[k].radius * balls[k].radius);
    }
    CHECK(line.pdf == Approx(pdf).epsilon(1e-12));
    both += in[0] && in[1];
    only_first += in[0] && !in[1];
    area += 1.0 / line.pdf / kCount;
  }
  CHECK(both > 0);
  CHECK(only_first > 0);
  // Two circles of radii 1 and 2 whose centres are 1.5 apart share a lens-shaped area.
  const double d = 1.5, a = std::acos((d * d + 1.0 - 4.0) / (2.0 * d)),
               b = std::acos((d * d + 4.0 - 1.0) / (4.0 * d));
  const double shared = a - 0.5 * std::sin(2.0 * a) + 4.0 * (b - 0.5 * std::sin(2.0 * b));
  CHECK(area == Approx(5.0 * pi - shared).epsilon(1e-2));
}

TEST_CASE("lines of parallel light begin before planes without end") {
  const ParallelTargets targets({{dvec3(0.0), 1.0}}, {dvec3(0.0), 2.0}, {{{0, 0, 50}, {0, 0, 1}}});
  const ParallelSample line = targets.sample({0, 0, -1}, {0.3, 0.4});
  CHECK(line.place.z > 50.0);
  CHECK_FALSE(targets.empty());
  CHECK(ParallelTargets({}, {dvec3(0.0), 2.0}, {}).empty());
}
