#include "io/console/progress.h"

#include "core/adaptive/noise.h"
#include "core/film/lost_light.h"
#include "io/console/terminal.h"

#include <fmt/format.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

std::string clock(double seconds) {
  const auto s = std::lround(seconds);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

double million_per_second(std::uint64_t rays, double seconds) {
  return seconds > 0.0 ? static_cast<double>(rays) / seconds * 1e-6 : 0.0;
}

std::string text(const RenderProgress& p) {
  const double left = p.fraction > 0.0 ? p.seconds * (1.0 - p.fraction) / p.fraction : 0.0;
  return fmt::format("{:3.0f} %  elapsed {}  left {}  {:.2f} Mray/s{}", 100.0 * p.fraction,
                     clock(p.seconds), clock(left), million_per_second(p.rays.total(), p.seconds),
                     p.light_paths ? "  light paths" : "");
}

double peak_memory_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

} // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::tell(const RenderProgress& progress) {
  if (quiet_) return;
  if (terminal_) {
    put_error(fmt::format("\r{}\x1b[K", text(progress)));
    line_open_ = true;
    return;
  }
  const int tenths = static_cast<int>(progress.fraction * 10.0 + 1e-9);
  if (tenths == told_tenths_) return;
  told_tenths_ = tenths;
  say_error(text(progress));
}

void Progress::finish() {
  if (line_open_) put_error("\n");
  line_open_ = false;
}

namespace {

/// How far the samples went, for a film that can tell.
std::string reached(const Rendering& rendering) {
  const Film& film = rendering.film;
  if (!film.keeps_errors()) return "";
  const SampleCounts samples = sample_counts(film);
  const double error = relative_error(film, film.window());
  std::string text = fmt::format(
      "samples a pixel: {} to {}, mean {:.1f}; estimated relative error {}", samples.least,
      samples.most, samples.mean, std::isfinite(error) ? fmt::format("{:.3g}", error) : "unknown");
  if (rendering.open_tiles > 0)
    text += fmt::format("; above the target: {} {}", rendering.open_tiles,
                        rendering.open_tiles == 1 ? "tile" : "tiles");
  return text + "\n";
}

/// What light paths did and how fast, where there are any.
std::string lighting(const Rendering& rendering) {
  const RayCounts& rays = rendering.rays;
  if (rays.light == 0) return "";
  return fmt::format("light paths: {} in {:.2f} s, {:.2f} million/s; {} splats, {} photons\n",
                     rays.light, rendering.light_seconds,
                     million_per_second(rays.light, rendering.light_seconds), rays.splats,
                     rays.photons);
}

/// A limit of depth that takes more than this part of the light is warned of.
constexpr double kMuchLight = 1e-3;

std::string percent(const LostShare& lost) {
  return fmt::format("{:.2g} % (standard error {:.1g} %)", 100.0 * lost.share, 100.0 * lost.error);
}

std::string limits(const Rendering& rendering) {
  const auto lost = lost_share(rendering.film);
  return lost ? fmt::format("depth limit: it took {} of the light\n", percent(*lost)) : "";
}

} // namespace

std::string light_warning(const Rendering& rendering) {
  const auto lost = lost_share(rendering.film);
  if (!lost || lost->share <= kMuchLight) return "";
  return fmt::format("the depth limit took {} of the picture's light; without maxRecursionDepth "
                     "and --depth none is lost",
                     percent(*lost));
}

std::string summary(const Rendering& rendering) {
  const RayCounts& rays = rendering.rays;
  const RefusedValues& refused = rendering.film.refused();
  return reached(rendering) +
         fmt::format("rays: {} camera, {} reflected, {} refracted, {} scattered, {} shadow, "
                     "{} light; {} in {:.2f} s, "
                     "{:.2f} Mray/s\n"
                     "{}{}"
                     "refused samples: {} not finite, {} negative, {} overflow{}\n"
                     "peak memory: {:.0f} MiB",
                     rays.camera, rays.reflected, rays.refracted, rays.scattered, rays.shadow,
                     rays.light, rays.total(), rendering.seconds,
                     million_per_second(rays.total(), rendering.seconds), lighting(rendering),
                     limits(rendering), refused.not_finite, refused.negative, refused.overflow,
                     rays.not_finite > 0
                         ? fmt::format("; refused rays: {} not finite", rays.not_finite)
                         : "",
                     peak_memory_mib());
}

} // namespace abbe
