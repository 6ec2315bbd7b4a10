#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

namespace {

/// A white card of radiance 1 behind N panes of glass, met head-on.
Scene card_behind(int panes, const std::string& integrator, int samples) {
  std::string text = "eye 0 0 50 lookAt 0 0 0 fieldOfView 2 imageSize 8 8 bands 5 caustics off\n"
                     "integrator " +
                     integrator + " samples " + std::to_string(samples) +
                     "\ndefaultMaterials ambient 0 0 0 diffuse 0 0 0 emissive E 1\n"
                     "push translate 0 0 -60 scale 10 10 1 square pop\n"
                     "emissive 0 0 0 speedOfLight 1.5 transparency 1 reflectivity 1\n"
                     "def pane { push scale 8 8 0.1 cube pop translate 0 0 -1 }\n"
                     "push translate 0 0 6\n";
  for (int i = 0; i < panes; ++i)
    text += "use pane\n";
  return test::scene_from(text + "pop");
}

double mean_radiance(const Film& film) {
  double sum = 0.0;
  for_each_pixel(film.window(), [&](int x, int y) { sum += film.radiance(x, y, 2); });
  return sum / static_cast<double>(film.window().pixel_count());
}

/// 2 N surfaces of reflectance R = 0.04 in a row, all orders of reflection between them.
double transmittance(int panes) {
  return 0.96 / (1.0 + (2 * panes - 1) * 0.04);
}

} // namespace

// A sample that follows one path of full weight is 1 with the chance T and else 0; trees and
// branches only lessen its variance T (1 - T).
TEST_CASE("a stack of panes lets through what the closed form says, however many there are") {
  constexpr int kSamples = 256, kPixels = 64;
  for (const char* integrator : {"whitted", "path"})
    for (const int panes : {1, 2, 4, 8, 9, 12, 20, 32, 50}) {
      const double t = transmittance(panes);
      const double error = std::sqrt(t * (1.0 - t) / (kSamples * kPixels));
      INFO(integrator << ", panes: " << panes);
      const Rendering r = test::render_scene(card_behind(panes, integrator, kSamples), true);
      CHECK(mean_radiance(r.film) == Approx(t).margin(4.0 * error));
    }
}

// A path through N panes crosses 2 N surfaces in the mean. What a sample costs may grow no faster
// than that from a stack whose tree is followed as a whole.
TEST_CASE("fifty panes cost at most 8 times as many rays as eight") {
  const auto rays = [](int panes) {
    return static_cast<double>(
        test::render_scene(card_behind(panes, "whitted", 16), false).rays.total());
  };
  const double eight = rays(8);
  CHECK(rays(50) < 8.0 * eight);
  // 8 panes took 110 rays a sample when a path ended at 16 surfaces, whatever it carried.
  CHECK(rays(50) < 3.0 * 110.0 * 64 * 16);
}

TEST_CASE("paths between perfect mirrors end") {
  for (const char* integrator : {"whitted", "path"}) {
    Scene scene = test::scene_from(
        "background E 1 eye 0.1 0.2 0.3 lookAt 0 0 -1 imageSize 2 2 samples 4 bands 5\n"
        "fresnel off reflectivity 1 ambient 0 0 0 diffuse 0 0 0 sphere\n"
        "integrator " +
        std::string(integrator));
    const Rendering r = test::render_scene(scene, false);
    CHECK(r.complete);
    CHECK(r.rays.total() > 16 * 512); // they do not end where light could still be found
  }
}
