#include "core/integrators/light_paths.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "tests/catch.h"
#include "tests/seeds.h"

#include <cmath>
#include <string>
#include <vector>

using namespace abbe;

// How fast what light paths bring comes close to what it should be.

namespace {

/// A ball of glass over a floor, seen from the side.
const std::string kFloor =
    "integrator path maxRecursionDepth 12 eye 0 0.4 3 lookAt 0 -1 0 fieldOfView 22\n"
    "imageSize 8 8 samples 16\n"
    "defaultMaterials diffuse 0.7 0.7 0.7 specular 0 0 0\n"
    "push translate 0 -1 0 rotate -90 1 0 0 scale 3 3 1 square pop\n"
    "glass SF11 push translate 0 0.3 0 scale 0.6 0.6 0.6 sphere pop\n";

/// Luminance of the splats alone, per pixel.
std::vector<double> splats(const Scene& scene, const Plan& plan, const World& world,
                           std::uint32_t count, std::uint64_t seed) {
  Emission emission(scene, plan);
  emission.place(world);
  const PlacedCamera camera(scene, plan.settings, world);
  Film film({0, 0, 8, 8}, beauty_layers({.quantum = plan.quantum, .splats = true}));
  LightPaths paths(plan, world, emission, &camera, film);
  RayCounts counts;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Sampler sampler(~0, 0, i, seed);
    if (const auto ray = emission.lights().at(0).sample(sampler))
      paths.trace(*ray, sampler, 1.0 / count, nullptr, 0.0, counts);
  }
  paths.add_splats();
  film.add_light_passes(1.0);
  std::vector<double> result;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      result.push_back(film.color(x, y).y);
  return result;
}

/// The slope of the line of least squares through log2(error) at consecutive powers of two.
double slope(const std::vector<double>& errors) {
  const double middle = 0.5 * (static_cast<double>(errors.size()) - 1.0);
  double numerator = 0.0, denominator = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = static_cast<double>(i) - middle;
    numerator += x * std::log2(errors[i]);
    denominator += x * x;
  }
  return numerator / denominator;
}

} // namespace

TEST_CASE("the error of splats falls at least as the root of the number of light paths") {
  for (const std::string lamp :
       {"falloff square light E 0.3 2.2 0 1",
        "defaultMaterials emissive E 3 translate 0.3 2.2 0 scale 0.5 0.5 0.5 sphere"}) {
    const Scene scene = test::scene_from(kFloor + lamp);
    const Plan plan = make_plan(scene, scene.settings);
    const World world(scene.shapes, farthest_coordinate(scene));
    const std::vector<double> reference = splats(scene, plan, world, 1u << 19, 1000);
    std::vector<double> errors;
    for (int k = 9; k <= 13; ++k) {
      constexpr int kSeeds = 16;
      double squares = 0.0;
      for (int seed = 1; seed <= kSeeds; ++seed) {
        const auto picture = splats(scene, plan, world, 1u << k, static_cast<std::uint64_t>(seed));
        for (std::size_t i = 0; i < picture.size(); ++i)
          squares += std::pow(picture[i] - reference[i], 2);
      }
      errors.push_back(std::sqrt(squares / kSeeds / 64.0));
    }
    CHECK(slope(errors) <= -0.45);
  }
}

// A camera with a lens, however small, gets all caustics from the photon map, and a pinhole gets
// them by splats, which have no bias.
TEST_CASE("caustics from the photon map come close to those of splats with more passes") {
  // Three surfaces at most: floors that light each other would bring noise of the camera's paths.
  Scene scene = test::scene_from(kFloor + "maxRecursionDepth 3 filter box\n"
                                          "falloff square light E 0.3 2.2 0 1");
  scene.settings.light_paths = 512.0;
  const auto splatted = test::over_seeds(scene, 3);
  scene.camera.kind = ThinLens{1e-6};
  scene.settings.light_paths = 16.0; // 2^14 a pass
  struct Distance {
    double total, pixels; ///< of the mean; root mean square of single images' pixels
  };
  const auto distance = [&](int passes, int seeds) {
    scene.settings.samples_per_pixel = 16 * passes;
    const auto mapped = test::over_seeds(scene, seeds);
    double squares = 0.0;
    for (std::size_t i = 0; i < mapped.mean.size(); ++i)
      squares += std::pow(mapped.mean[i] - splatted.mean[i], 2) + (seeds - 1) * mapped.variance[i];
    return Distance{std::abs(mapped.total / splatted.total - 1.0),
                    std::sqrt(squares / 64.0) / splatted.total};
  };
  const Distance one = distance(1, 16), many = distance(16, 4);
  // As passes^(-1/3) or faster.
  CHECK(many.pixels < std::pow(16.0, -1.0 / 3.0) * one.pixels);
  CHECK(many.pixels < 0.045);
  CHECK(many.total < 0.005);
}
