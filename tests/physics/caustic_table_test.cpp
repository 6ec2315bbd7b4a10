#include "tests/catch.h"
#include "tests/seeds.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <string>

using namespace abbe;

namespace {

struct Errors {
  double rms, noise, bias, total; ///< of the mean luminance; the first three of an image's pixels
};

/// Against an image whose own noise is small; what it has is taken off.
Errors errors(const test::SeedStatistics& picture, const test::SeedStatistics& reference,
              int seeds) {
  double noise2 = 0.0, bias2 = 0.0;
  for (std::size_t i = 0; i < picture.mean.size(); ++i) {
    noise2 += seeds * picture.variance[i];
    bias2 += std::pow(picture.mean[i] - reference.mean[i], 2) - picture.variance[i] -
             reference.variance[i];
  }
  const double scale = 1.0 / static_cast<double>(picture.mean.size());
  bias2 = std::max(0.0, bias2);
  return {std::sqrt((noise2 + bias2) * scale) / reference.total,
          std::sqrt(noise2 * scale) / reference.total, std::sqrt(bias2 * scale) / reference.total,
          picture.total / reference.total - 1.0};
}

} // namespace

// Not run by itself; prints the table in docs/decisions/caustics.md:
//   test_physics "[convergence]"
// A ball of glass throws its caustic on a floor. Nothing but the caustic is noisy: lights are
// points, and paths end before floors light each other. A lens camera with a tiny lens gets by the
// photon map what a pinhole gets by splats.
TEST_CASE("how fast caustics come close to what they should be", "[.][convergence]") {
  const std::string scene_text =
      "integrator path maxRecursionDepth 3 filter box\n"
      "eye 0 0.4 3 lookAt 0 -1 0 fieldOfView 22 imageSize 48 48\n"
      "defaultMaterials diffuse 0.7 0.7 0.7 specular 0 0 0\n"
      "push translate 0 -1 0 rotate -90 1 0 0 scale 3 3 1 square pop\n"
      "glass SF11 push translate 0 0.3 0 scale 0.6 0.6 0.6 sphere pop falloff square\n";
  for (const std::string lamp :
       {"light E 0.3 2.2 0 1", "softEdge 5 spotlight E 0.3 2.2 0 1 -0.3 -1.9 0 30"}) {
    Scene scene = test::scene_from(scene_text + lamp);
    scene.settings.samples_per_pixel = 256;
    scene.settings.light_paths = 6.0;
    const auto reference = test::over_seeds(scene, 4);
    for (const bool mapped : {false, true}) {
      std::cout << lamp << (mapped ? ": photon map\n" : ": splats\n");
      Scene again = scene;
      if (mapped) again.camera.kind = ThinLens{1e-6};
      again.settings.light_paths = 0.45; // 2^14 a pass
      double first = 0.0, last = 0.0;
      for (const int passes : {1, 4, 16, 64}) {
        constexpr int kSeeds = 3;
        again.settings.samples_per_pixel = 16 * passes;
        const Errors e = errors(test::over_seeds(again, kSeeds), reference, kSeeds);
        std::cout << fmt::format(
            "{:3} passes: rms {:.4f}, noise {:.4f}, bias {:.4f}, total {:+.4f}\n", passes, e.rms,
            e.noise, e.bias, e.total);
        (passes == 1 ? first : last) = e.rms;
      }
      const double slope = std::log(last / first) / std::log(64.0);
      std::cout << fmt::format("slope {:.2f}\n", slope) << std::flush;
      CHECK(slope < (mapped ? -1.0 / 3.0 : -0.48));
    }
  }
}
