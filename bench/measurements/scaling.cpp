#include "bench/measurements/scaling.h"
#include "core/planning/make_plan.h"

#include "bench/measurements/generated_scenes.h"
#include "bench/measurements/memory.h"

#include <fmt/format.h>

namespace abbe::bench {
namespace {

/// What rays need of a scene.
struct Built {
  Scene scene;
  World world;
};

/// `build` makes the scene from what is in memory before.
PrimitivePoint measure_primitives(std::size_t count, const RenderOptions& options,
                                  const std::function<Scene()>& build) {
  PrimitivePoint point;
  point.primitives = count;
  std::optional<Built> built;
  const auto build_all = [&] {
    Scene scene = build();
    World world = build_world(scene);
    built.emplace(std::move(scene), std::move(world));
  };
  build_all(); // Embree and TBB set themselves up
  built.reset();
  const std::size_t before = resident_bytes();
  build_all();
  point.bytes = added_bytes(before);
  Runs builds;
  for (int i = 0; i < options.repeats; ++i) {
    built.reset();
    const Seconds seconds = time_of(build_all);
    builds.wall.push_back(seconds.wall);
    builds.cpu.push_back(seconds.cpu);
  }
  point.build_seconds = builds.cpu_summary();
  point.build_wall_seconds = builds.wall_summary();

  RenderOptions with_bands = options;
  if (!with_bands.bands) with_bands.bands = 1;
  const Plan plan = make_plan(built->scene, settings_for(built->scene, with_bands));
  const auto render = [&] {
    point.rays = render_once(built->scene, plan, built->world).rays.total();
  };
  const Runs renders = interleaved({render}, options.repeats, true).front();
  point.render_seconds = renders.cpu_summary();
  point.wall_seconds = renders.wall_summary();
  return point;
}

/// Powers of ten.
std::vector<std::size_t> decades(std::size_t first, std::size_t last) {
  std::vector<std::size_t> counts;
  for (std::size_t n = first; n <= last; n *= 10)
    counts.push_back(n);
  return counts;
}

} // namespace

PrimitivePoint measure_triangles(std::size_t count, const RenderOptions& options) {
  const Triangles ball = ball_of_triangles(count);
  return measure_primitives(count, options,
                            [&] { return mesh_scene(Mesh(ball.vertices, ball.triangles)); });
}

PrimitivePoint measure_lenses(std::size_t count, const RenderOptions& options) {
  return measure_primitives(count, options, [count] { return lens_scene(count); });
}

Scaling measure_scaling(const std::filesystem::path& scene_path, const ScalingOptions& options,
                        const std::function<void(const std::string&)>& tell) {
  const Scene scene = load_scene(scene_path);
  Scaling result{scene.title, settings_for(scene, options.render), {}, {}, {}, {}, {}};
  const int repeats = options.render.repeats;
  for (const Axis axis : options.axes) {
    switch (axis) {
    case Axis::threads:
      tell("threads");
      result.threads = measure_threads(scene, result.settings, repeats);
      break;
    case Axis::size:
      tell("image size");
      result.sizes = measure_sizes(scene, result.settings, repeats);
      break;
    case Axis::samples:
      tell("samples");
      result.samples = measure_samples(scene, result.settings, repeats);
      break;
    case Axis::triangles:
      for (const std::size_t count : decades(10, options.most_triangles)) {
        tell(fmt::format("{} triangles", count));
        result.triangles.push_back(measure_triangles(count, options.render));
      }
      break;
    case Axis::lenses:
      for (const std::size_t count : decades(1, options.most_lenses)) {
        tell(fmt::format("{} lenses", count));
        result.lenses.push_back(measure_lenses(count, options.render));
      }
      break;
    }
  }
  return result;
}

} // namespace abbe::bench
