// scenes/colorchecker.sdl: a chart of flat patches under a parallel light that faces it. Each point
// of a patch sends out reflectance times the light's spectrum, so each pixel that lies wholly
// inside a patch has the patch's XYZ: the sum over 81 bands of reflectance x light x observer
// [CIE15].

#include "core/image/develop.h"
#include "core/planning/make_plan.h"
#include "spectral/color_difference.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"
#include "tests/spectral/expected.h"

#include <algorithm>
#include <cmath>

using namespace abbe;

namespace {

constexpr int kColumns = 6, kRows = 4;

/// The chart at 120 x 80 pixels, where the camera's 8 units of height give 9.6 pixels per unit: a
/// patch is 17 pixels wide and 19.3 from the next.
Scene chart(const std::string& illuminant) {
  const std::string path = std::string(ABBE_SOURCE_DIR) + "/scenes/colorchecker.sdl";
  std::string text = read_text_file(path);
  const std::size_t lamp = text.find("light D65 ");
  REQUIRE(lamp != text.npos);
  text.replace(lamp, 9, "light " + illuminant);
  Scene scene = read_scene_text(text, path, [](const std::string&) {});
  scene.settings.width = 120;
  scene.settings.height = 80;
  scene.settings.samples_per_pixel = 1;
  return scene;
}

Curve patch_reflectance(int patch) {
  const test::Expected table("colorchecker_ohta.csv");
  return Curve::samples81(table.numbers((patch < 10 ? "p0" : "p") + std::to_string(patch)));
}

/// The pixel in the middle of patch `index` (from 0), and six to each side of it.
template <class Use>
void for_pixels_of(int index, const Use& use) {
  const double pixels_per_unit =
      80.0 / (2.0 * 20.0 * std::tan(23.5 / 2.0 * 3.14159265358979 / 180));
  const int x = static_cast<int>(60.0 + 2.0 * (index % kColumns - 2.5) * pixels_per_unit);
  const int y = static_cast<int>(40.0 - 2.0 * (1.5 - index / kColumns) * pixels_per_unit);
  for (int dy = -6; dy <= 6; ++dy)
    for (int dx = -6; dx <= 6; ++dx)
      use(x + dx, y + dy);
}

} // namespace

TEST_CASE("every pixel of the chart's patches has the computed colour") {
  for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    for (const std::string name : {"D65", "A", "FL2"}) {
      Scene scene = chart(name);
      scene.settings.observer = observer;
      const Rendering rendering = test::render_scene(scene, false);
      const Curve light = *find_illuminant(name);
      const Xyz white = to_xyz(light, observer);
      for (int index = 0; index < kColumns * kRows; ++index) {
        INFO(name << ", patch " << index + 1);
        const Lab expected =
            to_lab(to_xyz(light.times(patch_reflectance(index + 1)), observer), white);
        double worst = 0.0;
        for_pixels_of(index, [&](int x, int y) {
          const Lab seen = to_lab(rendering.film.color(x, y), white);
          worst = std::max(worst, delta_e_2000(seen, expected));
        });
        CHECK(worst < 0.05);
      }
    }
}

TEST_CASE("with the light as white point the chart's greys are grey on every display") {
  Scene scene = chart("A");
  const Plan plan = make_plan(scene, scene.settings);
  const Rendering rendering = test::render_scene(scene, false);
  for (const char* name : {"srgb", "display-p3", "ntsc", "acescg"}) {
    DisplaySettings settings;
    settings.space = find_color_space(name).value();
    const auto spread = [&] { // the largest difference of components in the middle grey patch
      const DisplayImage image = develop_display(rendering.film, plan, settings);
      double most = 0.0;
      for_pixels_of(21, [&](int x, int y) {
        const float* rgb = image.linear.data() + 3 * (y * 120 + x);
        most = std::max<double>(most,
                                *std::max_element(rgb, rgb + 3) - *std::min_element(rgb, rgb + 3));
      });
      return most;
    };
    INFO(name);
    CHECK(spread() > 0.08); // what is, is shown
    settings.white_point = WhitePoint::of_light(*find_illuminant("A"));
    CHECK(spread() < 0.01); // neutral 5 is not quite flat
  }
}
