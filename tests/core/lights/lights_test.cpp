#include "core/lights/lights.h"
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

/// A scene with its lights.
struct Lit {
  Scene scene;
  Plan plan;
  Lights lights;

  explicit Lit(const std::string& text)
      : scene(test::scene_from("integrator path\n" + text)), plan(make_plan(scene, scene.settings)),
        lights(scene, plan) {}
};

std::string notes(const Plan& plan) {
  std::string all;
  for (const std::string& note : plan.notes)
    all += note + "\n";
  return all;
}

} // namespace

// What each can send to the place (0.3, 5.2, 1.5): a point of intensity I gives I / d^2, and a cone
// of 60 degrees within it the same; without falloff a light gives pi, as parallel light does; a
// ball of radius 1 shows the area pi, a square of 2 by 2 half of its area where both sides shine,
// and all of it where the place lies before its front, less than the angle that it fills off its
// axis.
TEST_CASE("lights are chosen by what they can send to a place") {
  const Lit lit("falloff square intensity 90 light E 0 0 9 1 spotlight E 0 0 9 1 0 0 -1 60\n"
                "falloff none intensity 1 light E 0 0 1 0\n"
                "diffuse 0 0 0 emissive E 1 sphere translate 0 5 0 square emissiveSides front "
                "emissive E 2 square");
  const Scene& scene = lit.scene;
  REQUIRE(scene.lights.size() == 3);
  const dvec3 place(0.3, 5.2, 1.5); // lit by all, from above and from the front
  const auto falls = [&](const dvec3& from) {
    const dvec3 way = place - from;
    return 1.0 / glm::dot(way, way);
  };
  const std::array<double, 6> expected_light{
      90.0 * falls({0, 0, 9}), 90.0 * falls({0, 0, 9}), kPi,
      kPi * falls({0, 0, 0}),  2.0 * falls({0, 5, 0}),  2.0 * 4.0 * falls({0, 5, 0})};
  double total = 0.0;
  for (const double e : expected_light)
    total += e;

  constexpr int kDraws = 60000;
  std::array<double, 6> counts{};
  std::mt19937_64 engine(2);
  const auto number = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  for (int i = 0; i < kDraws; ++i) {
    const double choice = number(), x = number();
    const auto sample = lit.lights.sample(place, choice, {x, number()});
    REQUIRE(sample);
    const int source = sample->source;
    const std::size_t light =
        source >= 2 && source <= 4 ? static_cast<std::size_t>(source - 2)
        : source == lit.plan.materials[static_cast<std::size_t>(scene.shapes[2].material.index())]
                        .emission_source
            ? 5
        : std::abs((place + sample->distance * sample->direction).z) < 1e-9 &&
                (place + sample->distance * sample->direction).y > 3.0
            ? 4
            : 3;
    counts[light] += 1.0;
  }
  double chi_square = 0.0;
  for (std::size_t i = 0; i < expected_light.size(); ++i) {
    const double expected = kDraws * expected_light[i] / total;
    chi_square += std::pow(counts[i] - expected, 2) / expected;
    CAPTURE(i, counts[i], expected);
    CHECK(counts[i] == Approx(expected).epsilon(0.1));
  }
  CHECK(chi_square < 37.0); // five degrees of freedom: exceeded once in a million
}

TEST_CASE("a sun's directions come with the pdf that is claimed") {
  const Lit lit("sunRadius 20 sun 1 2 2 E square");
  const Cone disc = Cone::of_sine({1.0 / 3, 2.0 / 3, 2.0 / 3}, std::pow(std::sin(kPi / 9), 2));
  const auto check = test::check_sampling(
      disc,
      [&](const dvec2& u) {
        return std::optional(lit.lights.sample({0, 0, 0}, 0.0, u)->direction);
      },
      [&](const dvec3& v) { return disc.holds(v) ? disc.pdf() : 0.0; });
  CHECK(check.agrees());
  CHECK(check.integral == Approx(1.0));
  const auto sample = lit.lights.sample({0, 0, 0}, 0.0, {0.2, 0.7});
  CHECK(sample->pdf == Approx(1.0 / (2.0 * kPi * (1.0 - std::cos(kPi / 9)))));
  CHECK(sample->weight * sample->pdf == Approx(1.0 / std::pow(std::sin(kPi / 9), 2)));
}

TEST_CASE("a scene without extent keeps the lights that light it from afar") {
  CHECK_FALSE(Lit("light E 0 0 1 0 plane").lights.empty());
  CHECK_FALSE(Lit("light E 0 0 1 1 plane").lights.empty());
  CHECK_FALSE(Lit("sun 0 0 1 plane").lights.empty());
}

TEST_CASE("the plan tells of lights that are not aimed at") {
  const std::string glow = "defaultMaterials emissive E 1 ";
  CHECK(notes(Lit(glow + "cylinder").plan).find("1 shining shape is met by chance alone") !=
        std::string::npos);
  CHECK(notes(Lit(glow + "cone cylinder sphere").plan).find("2 shining shapes are met") !=
        std::string::npos);
  CHECK(notes(Lit(glow + "sphere cube square disc").plan).find("by chance") == std::string::npos);
  CHECK(notes(Lit(glow + "integrator whitted cone").plan).find("by chance") == std::string::npos);
  CHECK(Lit(glow + "cone").lights.empty());
}
