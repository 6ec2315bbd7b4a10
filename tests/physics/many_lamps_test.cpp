#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <random>
#include <string>

using namespace abbe;

namespace {

/// A floor under lamps of three kinds, of which each lights a part of it.
std::string lamps(int count) {
  std::mt19937 engine(7);
  const auto number = [&] { return static_cast<double>(engine()) * 0x1p-32; };
  std::string text = "ambient 0 0 0 diffuse 0.5 0.5 0.5 push scale 9 9 9 square pop falloff square "
                     "filter box eye 0 0 20 lookAt 0 0 0 up 0 1 0 fieldOfView 40 imageSize 8 8\n";
  for (int i = 0; i < count; ++i) {
    const std::string place = std::to_string(16.0 * number() - 8.0) + " " +
                              std::to_string(16.0 * number() - 8.0) + " " +
                              std::to_string(0.5 + 2.0 * number());
    text += "intensity " + std::to_string(0.1 + number()) +
            (i % 3 == 0 ? " spotlight E " + place + " 1 0.3 0.2 -1 40\n"
                        : " light E " + place + " 1\n");
  }
  return text;
}

struct Mean {
  double value, deviation; ///< and its standard error
};

/// Mean luminance over all pixels of independent renderings.
Mean mean_of(const std::string& text) {
  double sum = 0.0, squares = 0.0;
  constexpr int kSeeds = 16;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Scene scene = test::scene_from(text + "seed " + std::to_string(seed));
    const Rendering rendering = test::render_scene(scene, false);
    double y = 0.0;
    for (int row = 0; row < 8; ++row)
      for (int column = 0; column < 8; ++column)
        y += rendering.film.color(column, row).y / 64.0;
    sum += y;
    squares += y * y;
  }
  const double mean = sum / kSeeds;
  return {mean, std::sqrt(std::max(0.0, squares / kSeeds - mean * mean) / (kSeeds - 1))};
}

} // namespace

// Integrator whitted sends a ray to every lamp, without a choice.
TEST_CASE("one lamp of many, chosen for each place, lights as all of them do") {
  const std::string scene = lamps(120);
  const Mean all = mean_of("integrator whitted samples 16\n" + scene);
  const Mean one = mean_of("integrator path maxRecursionDepth 1 samples 64\n" + scene);
  CAPTURE(all.value, all.deviation, one.value, one.deviation);
  CHECK(std::abs(one.value - all.value) < 4.5 * std::hypot(one.deviation, all.deviation));
  CHECK(one.deviation < 0.01 * one.value);
}
