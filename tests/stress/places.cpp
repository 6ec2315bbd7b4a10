// The project's scenes at other scales and places: each must give the same picture. Both are
// rendered small, with the same random numbers, and compared pixel by pixel; see docs/stability.md.
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/render.h"
#include "io/scene_files/read_scene_file.h"
#include "tests/stress/moved_scene.h"
#include "tests/stress/part.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace abbe::stress {
namespace {

/// The first of them make the short form: a prism, a boolean, a lens that is a camera, photons.
constexpr const char* kScenes[] = {
    "prism_view.sdl",
    "csg_zoo.sdl",
    "lens_camera.sdl",
    "glass_sphere_caustic.sdl",
    "achromat.sdl",
    "brilliant.sdl",
    "bubble.sdl",
    "colorchecker.sdl",
    "cornell.sdl",
    "cornell_glass.sdl",
    "cornell_thesis.sdl",
    "cube.sdl",
    "gem.sdl",
    "gem_caustic.sdl",
    "glass_ball.pbrt",
    "lens.sdl",
    "lens_camera_achromat.sdl",
    "lens_exaggerated.sdl",
    "lens_focus.sdl",
    "metamerism_back.sdl",
    "metamerism_front.sdl",
    "metamerism_white.sdl",
    "newton.sdl",
    "newton_two_prisms.sdl",
    "prism_a.sdl",
    "prism_b.sdl",
    "prism_c.sdl",
    "rainbow.sdl",
    "raindrop.sdl",
    "rough_glass.sdl",
    "sphere.sdl",
    "sphere_achromatic.sdl",
};
constexpr std::size_t kShortScenes = 4;

/// A scale, and by how many of its sizes a scene is moved then.
struct Placement {
  double scale, sizes;
};
constexpr Placement kPlacements[] = {{1e-4, 0.0}, {1e4, 0.0},  {1.0, 1e3}, {1.0, 1e6},
                                     {1e-4, 1e3}, {1e-4, 1e6}, {1e4, 1e3}, {1e4, 1e6}};

/// A deviation of this many standard errors is looked at again with new random numbers, in all
/// kStages times. A right picture fails with a chance of 1e-10 for each colour.
constexpr double kSuspicious = 3.5;
constexpr int kStages = 3;
/// What floats round in the mean, of the picture's own mean: throughputs and radiances are floats.
constexpr double kRounding = 1e-5;

Rendering picture(const Scene& scene) {
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  return render(scene, plan, world, std::nullopt);
}

std::array<double, 3> values(const Xyz& color) {
  return {color.x, color.y, color.z};
}

/// A mean, and its standard error, of independent values.
class Mean {
public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  [[nodiscard]] double mean() const { return sum_ / count_; }
  [[nodiscard]] double error() const {
    return std::sqrt(std::max(0.0, squares_ / count_ - mean() * mean()) / (count_ - 1.0));
  }

private:
  double count_ = 0.0, sum_ = 0.0, squares_ = 0.0;
};

/// How the pictures of two scenes with the same random numbers differ; nothing where they do not.
std::optional<std::string> difference(const Scene& scene, const Scene& moved) {
  const Rendering a = picture(scene), b = picture(moved);
  for (std::size_t i = 0; i < 3; ++i) {
    Mean differences;
    double whole = 0.0;
    for (int y = 0; y < scene.settings.height; ++y)
      for (int x = 0; x < scene.settings.width; ++x) {
        const double before = values(a.film.color(x, y))[i];
        differences.add(values(b.film.color(x, y))[i] - before);
        whole += before / (scene.settings.width * scene.settings.height);
      }
    const double off = std::abs(differences.mean());
    if (off > kSuspicious * differences.error() + kRounding * whole)
      return fmt::format("{} is off by {} +- {} of {}", "XYZ"[i], differences.mean(),
                         differences.error(), whole);
  }
  return std::nullopt;
}

void round(std::uint64_t number, Tally& tally) {
  const char* name = kScenes[number / std::size(kPlacements) % std::size(kScenes)];
  const Placement& placement = kPlacements[number % std::size(kPlacements)];
  Scene scene =
      read_scene_file(std::string(ABBE_SOURCE_DIR) + "/scenes/" + name, [](const std::string&) {});
  scene.settings.width = scene.settings.height = 20;
  scene.settings.crop.reset();
  scene.settings.samples_per_pixel = 2;
  scene.settings.adaptive = AdaptiveSampling::off;
  scene.settings.noise = scene.settings.seconds = 0.0;
  scene.settings.threads = 1;
  const double size = placement.scale * size_of(scene);
  const Scene moved =
      moved_scene(scene, placement.scale, placement.sizes * size * dvec3(0.8, -0.35, 0.48));
  std::optional<std::string> found;
  for (int stage = 0; stage < kStages; ++stage) {
    const auto seeded = [&](Scene again) {
      again.settings.seed += static_cast<std::uint64_t>(stage) * 1000;
      return again;
    };
    tally.count("pictures_compared");
    found = difference(seeded(scene), seeded(moved));
    if (!found) return;
  }
  tally.fail("place", fmt::format("round {}: {} at scale {}, moved by {} sizes: {}", number, name,
                                  placement.scale, placement.sizes, *found));
}

} // namespace

const Part kPart{"places", kShortScenes* std::size(kPlacements),
                 std::size(kScenes) * std::size(kPlacements), Rounds::on_all_cores, round};

} // namespace abbe::stress
