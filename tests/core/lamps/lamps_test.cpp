#include "core/lamps/lamps.h"
#include "core/planning/make_plan.h"

#include "tests/catch.h"
#include "tests/core/emitters/direction_sampling.h"
#include "tests/render_text.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi;

/// A scene with its lamps.
struct Lit {
  Scene scene;
  Plan plan;
  Lamps lamps;

  explicit Lit(const std::string& text)
      : scene(test::scene_from("integrator path\n" + text)), plan(make_plan(scene, scene.settings)),
        lamps(scene, plan) {}
};

std::string notes(const Plan& plan) {
  std::string all;
  for (const std::string& note : plan.notes)
    all += note + "\n";
  return all;
}

} // namespace

// Powers: a ball of radius 1 and radiance 1 has pi 4 pi; a square with both sides pi 8, with one
// pi 4; a point of intensity 1 has 4 pi; a cone of 60 degrees half of 2 pi; parallel light pi
// through a disc about the scene.
TEST_CASE("lamps are chosen in proportion to their power") {
  const Lit lit("falloff square light E 0 0 9 1 spotlight E 0 0 9 1 0 0 -1 60 falloff none\n"
                "light E 0 0 1 0\n"
                "diffuse 0 0 0 emissive E 1 sphere translate 0 5 0 square emissiveSides front "
                "emissive E 2 square");
  const Scene& scene = lit.scene;
  REQUIRE(scene.lights.size() == 3);
  std::array<double, 6> power{4.0 * kPi, kPi, 0.0, 4.0 * kPi * kPi, 8.0 * kPi, 8.0 * kPi};
  Bounds box;
  for (const PlacedShape& shape : scene.shapes)
    box = box.joined(bounds(shape));
  box = box.joined({{0, 0, 9}, {0, 0, 9}});
  power[2] = kPi * kPi * 0.25 * glm::dot(box.upper - box.lower, box.upper - box.lower);
  double total = 0.0;
  for (const double p : power)
    total += p;

  constexpr int kDraws = 60000;
  std::array<double, 6> counts{};
  std::mt19937_64 engine(2);
  const auto number = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  const dvec3 place(0.3, 5.2, 1.5); // lit by all, from above and from the front
  for (int i = 0; i < kDraws; ++i) {
    const double choice = number(), x = number();
    const auto sample = lit.lamps.sample(place, choice, {x, number()});
    REQUIRE(sample);
    const int source = sample->source;
    const std::size_t lamp =
        source >= 2 && source <= 4 ? static_cast<std::size_t>(source - 2)
        : source == lit.plan.materials[static_cast<std::size_t>(scene.shapes[2].material.index())]
                        .emission_source
            ? 5
        : std::abs((place + sample->distance * sample->direction).z) < 1e-9 &&
                (place + sample->distance * sample->direction).y > 3.0
            ? 4
            : 3;
    counts[lamp] += 1.0;
  }
  double chi_square = 0.0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    const double expected = kDraws * power[i] / total;
    chi_square += std::pow(counts[i] - expected, 2) / expected;
    CAPTURE(i, counts[i], expected);
    CHECK(counts[i] == Approx(expected).epsilon(0.1));
  }
  CHECK(chi_square < 37.0); // five degrees of freedom: exceeded once in a million
}

TEST_CASE("a sun's directions come with the density that is claimed") {
  const Lit lit("sunRadius 20 sun 1 2 2 E square");
  const Cone disc = Cone::of_sine({1.0 / 3, 2.0 / 3, 2.0 / 3}, std::pow(std::sin(kPi / 9), 2));
  const auto check = test::check_sampling(
      disc,
      [&](const dvec2& u) { return std::optional(lit.lamps.sample({0, 0, 0}, 0.0, u)->direction); },
      [&](const dvec3& v) { return disc.holds(v) ? disc.density() : 0.0; });
  CHECK(check.agrees());
  CHECK(check.integral == Approx(1.0));
  const auto sample = lit.lamps.sample({0, 0, 0}, 0.0, {0.2, 0.7});
  CHECK(sample->density == Approx(1.0 / (2.0 * kPi * (1.0 - std::cos(kPi / 9)))));
  CHECK(sample->weight * sample->density == Approx(1.0 / std::pow(std::sin(kPi / 9), 2)));
}

TEST_CASE("a scene without extent keeps the lamps that light it from afar") {
  CHECK_FALSE(Lit("light E 0 0 1 0 plane").lamps.empty());
  CHECK_FALSE(Lit("light E 0 0 1 1 plane").lamps.empty());
  CHECK_FALSE(Lit("sun 0 0 1 plane").lamps.empty());
}

TEST_CASE("the plan tells of lamps that are not aimed at") {
  const std::string glow = "defaultMaterials emissive E 1 ";
  CHECK(notes(Lit(glow + "cylinder").plan).find("1 shining shape is met by chance alone") !=
        std::string::npos);
  CHECK(notes(Lit(glow + "cone cylinder sphere").plan).find("2 shining shapes are met") !=
        std::string::npos);
  CHECK(notes(Lit(glow + "sphere cube square disc").plan).find("by chance") == std::string::npos);
  CHECK(notes(Lit(glow + "integrator whitted cone").plan).find("by chance") == std::string::npos);
  CHECK(Lit(glow + "cone").lamps.empty());
}
