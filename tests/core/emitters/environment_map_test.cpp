#include "core/emitters/environment_map.h"

#include "spectral/illuminant.h"
#include "spectral/rgb_spectrum.h"
#include "tests/catch.h"
#include "tests/core/emitters/direction_sampling.h"

#include <glm/geometric.hpp>

#include <numbers>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi;

/// A picture of greys.
Environment picture(int width, int height, const std::vector<float>& greys) {
  Environment e;
  e.width = width;
  e.height = height;
  for (const float v : greys)
    e.rgb.insert(e.rgb.end(), 3, v);
  return e;
}

double radiance(const EnvironmentMap& map, const dvec3& direction) {
  float value = 1.0f;
  map.scale(glm::normalize(direction), {&value, {0, 1}});
  return static_cast<double>(value);
}

EnvironmentMap map_of(const Environment& e) {
  return *EnvironmentMap::make(e, {550.0});
}

/// A bright spot, darkness around it, and some noise.
Environment uneven(int width, int height) {
  std::vector<float> greys;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      greys.push_back(x == 3 && y == 2 ? 60.0f
                      : x > 5          ? 0.0f
                                       : 0.3f * static_cast<float>((x * 7 + y * 5) % 4));
  return picture(width, height, greys);
}

const Cone kAll{{0.48, 0.6, 0.64}, 2.0};

} // namespace

TEST_CASE("the middle of the picture is along -z, its right is +x, its top +y") {
  // Columns -> +z/-x, -x.., -z.., +x..: middles of four columns are at -135, -45, 45, 135 degrees.
  const EnvironmentMap map = map_of(picture(4, 2, {1, 2, 3, 4, 5, 6, 7, 8}));
  const double s = std::sqrt(0.5);
  CHECK(radiance(map, {-s, 1, s}) == Approx(1.0));
  CHECK(radiance(map, {-s, 1, -s}) == Approx(2.0));
  CHECK(radiance(map, {s, 1, -s}) == Approx(3.0));
  CHECK(radiance(map, {s, 1, s}) == Approx(4.0));
  CHECK(radiance(map, {-s, -1, -s}) == Approx(6.0));
  CHECK(radiance(map, {0, 1, -1}) == Approx(2.5));   // between columns
  CHECK(radiance(map, {0, 0, -1}) == Approx(4.5));   // between rows too
  CHECK(radiance(map, {1e-9, 1, 1}) == Approx(2.5)); // across the seam: (1 + 4) / 2
  CHECK(radiance(map, {-1e-9, 1, 1}) == Approx(2.5));
}

TEST_CASE("an environment turns with its transform") {
  Environment e = picture(4, 2, {1, 2, 3, 4, 5, 6, 7, 8});
  e.to_world = glm::dmat3({0, 0, -1}, {0, 1, 0}, {1, 0, 0}); // a quarter turn about y: z to x
  const double s = std::sqrt(0.5);
  CHECK(radiance(map_of(e), {s, 1, s}) == Approx(1.0)); // (-s, 1, s) went to (s, 1, s)
}

TEST_CASE("directions of an environment come with the pdf that is claimed") {
  for (const auto& [width, height] : {std::pair(12, 6), std::pair(5, 1), std::pair(1, 4)}) {
    Environment e = uneven(width, height);
    if (width < 5) e = picture(width, height, {0.0f, 1.0f, 0.2f, 3.0f});
    const EnvironmentMap map = map_of(e);
    const auto check = test::check_sampling(
        kAll, [&](const dvec2& u) { return std::optional(map.sample(u)); },
        [&](const dvec3& v) { return map.pdf(v); }, 60000, 96);
    CAPTURE(width, height, check.chi_square, check.limit);
    CHECK(check.agrees());
    CHECK(check.drawn == Approx(1.0));
    CHECK(check.integral == Approx(1.0).epsilon(2e-3));
  }
}

TEST_CASE("all that shines can be chosen, and nothing else") {
  const EnvironmentMap map = map_of(uneven(12, 6));
  std::mt19937_64 engine(5);
  const auto number = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  for (int i = 0; i < 2000; ++i) {
    const dvec3 v = kAll.sample({number(), number()});
    CHECK((radiance(map, v) > 0.0) == (map.pdf(v) > 0.0));
    const dvec3 drawn = map.sample({number(), number()});
    CHECK(glm::length(drawn) == Approx(1.0).epsilon(1e-14));
    CHECK(map.pdf(drawn) > 0.0);
  }
}

TEST_CASE("a constant environment has its colour everywhere, at any band") {
  Environment e;
  e.width = 8;
  e.height = 4;
  for (int i = 0; i < 32; ++i)
    e.rgb.insert(e.rgb.end(), {0.5f, 2.0f, 0.25f});
  e.factor = 3.0;
  const EnvironmentMap map = *EnvironmentMap::make(e, {420.0, 550.0, 690.0});
  CHECK(map.total() == Approx(4.0 * kPi * luminance({1.5, 6.0, 0.75})).epsilon(1e-6));
  const Curve expected = rgb_emission({1.5, 6.0, 0.75});
  const Curve d65 = *find_illuminant("D65");
  for (const dvec3& v : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0.6, 0, 0.8), dvec3(0, 0, 1)}) {
    float values[3] = {1.0f, 1.0f, 2.0f};
    map.scale(v, {values, {0, 3}});
    CHECK(values[0] == Approx(expected.at(420.0) / d65.at(420.0)).epsilon(2e-3));
    CHECK(values[1] == Approx(expected.at(550.0) / d65.at(550.0)).epsilon(2e-3));
    CHECK(values[2] == Approx(2.0 * expected.at(690.0) / d65.at(690.0)).epsilon(2e-3));
    CHECK(map.pdf(v) == Approx(0.25 / kPi));
  }
  e.has_colors = false;
  CHECK(radiance(map_of(e), {0, 1, 0}) == Approx(luminance({1.5, 6.0, 0.75})));
}

TEST_CASE("a black picture is no lamp, and negative light counts as none") {
  CHECK_FALSE(EnvironmentMap::make(picture(2, 1, {0, 0}), {550.0}).has_value());
  CHECK_FALSE(EnvironmentMap::make(picture(2, 1, {-1, -2}), {550.0}).has_value());
  CHECK(radiance(map_of(picture(2, 1, {-1, 1})), {-1, 0, 0}) == 0.0);
}

// What is above the limit, summed over directions chosen evenly, and over those chosen for it.
TEST_CASE(
    "the bright part of an environment is what its luminance has above a multiple of its mean") {
  const EnvironmentMap even = *EnvironmentMap::make(uneven(8, 4), {550.0}, 0.0);
  const double mean = even.total() / (4.0 * kPi);
  for (const double times : {0.0, 1.5, 8.0}) {
    const EnvironmentMap map = *EnvironmentMap::make(uneven(8, 4), {550.0}, times);
    REQUIRE(map.has_bright());
    constexpr int kSide = 600;
    double sum = 0.0, pdf = 0.0, chosen = 0.0, worst = 0.0;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) {
        const dvec2 u{(i + 0.5) / kSide, (j + 0.5) / kSide};
        const dvec3 any = kAll.sample(u);
        const double value = radiance(map, any);
        const double bright = std::max(0.0, value - times * mean);
        sum += bright;
        pdf += map.bright_pdf(any);
        worst = std::max(worst, std::abs(map.bright_share(any) * value - bright));
        const dvec3 aimed = map.sample_bright(u);
        const double density = map.bright_pdf(aimed);
        if (density > 0.0) chosen += map.bright_share(aimed) * radiance(map, aimed) / density;
      }
    const double all = 4.0 * kPi / (kSide * kSide);
    CHECK(worst < 1e-4); // of 60, in single precision
    CHECK(all * pdf == Approx(1.0).epsilon(2e-3));
    CHECK(chosen / (kSide * kSide) == Approx(all * sum).epsilon(5e-3));
  }
  CHECK_FALSE(EnvironmentMap::make(uneven(8, 4), {550.0}, 1e15)->has_bright());
  CHECK_FALSE(
      EnvironmentMap::make(picture(4, 2, std::vector<float>(8, 3.0f)), {550.0}, 8.0)->has_bright());
}
