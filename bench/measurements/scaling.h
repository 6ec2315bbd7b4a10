#pragma once

#include "bench/measurements/setup.h"
#include "bench/measurements/timing.h"

namespace abbe::bench {

/// What is made larger and larger.
enum class Axis : std::uint8_t { threads, size, samples, triangles, lenses };

struct ScalingOptions {
  RenderOptions render;
  std::vector<Axis> axes{Axis::threads, Axis::size, Axis::samples, Axis::triangles, Axis::lenses};
  std::size_t most_triangles = 1'000'000, most_lenses = 10'000;
};

/// One number of threads. Times are wall time; ratios are those to one thread, round by round.
struct ThreadPoint {
  int threads = 1;
  Summary wall_seconds, render_seconds; ///< the second is processor time
  Summary loop_wall_seconds; ///< of the same arithmetic without memory, see arithmetic_loop
  Summary speedup, loop_speedup;

  /// How much of what the machine gives to so many threads the renderer makes use of.
  [[nodiscard]] double share_of_loop() const { return speedup.median / loop_speedup.median; }
};

/// One size of image or number of samples.
struct ImagePoint {
  RenderSettings settings;
  Summary render_seconds, wall_seconds;
  std::uint64_t rays = 0;
  std::optional<std::size_t> film_bytes, band_film_bytes; ///< of the sums; with all bands kept
};

/// One number of primitives.
struct PrimitivePoint {
  std::size_t primitives = 0;
  Summary build_seconds, build_wall_seconds; ///< all hierarchies, from shapes in memory
  Summary render_seconds, wall_seconds;
  std::uint64_t rays = 0;
  std::optional<std::size_t> bytes; ///< what the built scene keeps
};

struct Scaling {
  std::string scene; ///< of threads, sizes and samples
  RenderSettings settings;
  std::vector<ThreadPoint> threads;
  std::vector<ImagePoint> sizes, samples;
  std::vector<PrimitivePoint> triangles, lenses;
};

/// Primitives are rendered with one band unless the options say otherwise.
[[nodiscard]] Scaling measure_scaling(const std::filesystem::path& scene,
                                      const ScalingOptions& options,
                                      const std::function<void(const std::string&)>& tell);

// The parts of it.
[[nodiscard]] std::vector<ThreadPoint> measure_threads(const Scene& scene,
                                                       const RenderSettings& settings, int repeats);
[[nodiscard]] std::vector<ImagePoint> measure_sizes(const Scene& scene,
                                                    const RenderSettings& settings, int repeats);
[[nodiscard]] std::vector<ImagePoint> measure_samples(const Scene& scene,
                                                      const RenderSettings& settings, int repeats);
[[nodiscard]] PrimitivePoint measure_triangles(std::size_t count, const RenderOptions& options);
[[nodiscard]] PrimitivePoint measure_lenses(std::size_t count, const RenderOptions& options);

} // namespace abbe::bench
