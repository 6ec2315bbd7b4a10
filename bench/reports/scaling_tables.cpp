#include "bench/reports/figures.h"
#include "bench/reports/result_tables.h"

#include <fmt/format.h>

namespace abbe::bench {
namespace {

/// `bytes` over a number of things.
std::string bytes_each(const std::optional<std::size_t>& bytes, std::size_t things) {
  return bytes ? fmt::format("{:.0f}", static_cast<double>(*bytes) / static_cast<double>(things))
               : "-";
}

std::string nanoseconds_each(double seconds, std::uint64_t things) {
  return fmt::format("{:.1f}", seconds * 1e9 / static_cast<double>(things));
}

Table threads_table(const Scaling& s) {
  Table table{fmt::format("{}, {}, {} bands, {} spp, by threads", s.scene, size_text(s.settings),
                          s.settings.bands, s.settings.samples_per_pixel),
              {"threads", "wall s", "+- %", "seconds", "t1/tN", "loop t1/tN", "share of loop"},
              {},
              {"t1/tN: wall time on one thread over this; of a rendering, and of a loop of "
               "arithmetic without memory."}};
  for (const ThreadPoint& p : s.threads)
    table.rows.push_back({fmt::format("{}", p.threads), seconds_text(p.wall_seconds.median),
                          range_text(p.wall_seconds), seconds_text(p.render_seconds.median),
                          fmt::format("{:.2f}", p.speedup.median),
                          fmt::format("{:.2f}", p.loop_speedup.median),
                          fmt::format("{:.2f}", p.share_of_loop())});
  return table;
}

Table pictures_table(const Scaling& s, const std::vector<ImagePoint>& points, const char* by) {
  Table table{fmt::format("{}, {} bands, by {}", s.scene, s.settings.bands, by),
              {"size", "spp", "seconds", "+- %", "wall s", "rays", "ns/ray", "ns/sample",
               "film B/pixel", "with all bands"},
              {},
              {}};
  for (const ImagePoint& p : points) {
    const RenderSettings& r = p.settings;
    const auto pixels =
        r.crop ? r.crop->pixel_count()
               : static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height);
    const auto samples = pixels * static_cast<std::size_t>(r.samples_per_pixel);
    table.rows.push_back({size_text(r), fmt::format("{}", r.samples_per_pixel),
                          seconds_text(p.render_seconds.median), range_text(p.render_seconds),
                          seconds_text(p.wall_seconds.median), fmt::format("{}", p.rays),
                          nanoseconds_each(p.render_seconds.median, p.rays),
                          nanoseconds_each(p.render_seconds.median, samples),
                          bytes_each(p.film_bytes, pixels), bytes_each(p.band_film_bytes, pixels)});
  }
  return table;
}

Table primitives_table(const Scaling& s, const std::vector<PrimitivePoint>& points,
                       const char* what) {
  Table table{
      fmt::format("{}, {}, {} spp", what, size_text(s.settings), s.settings.samples_per_pixel),
      {"primitives", "build s", "+- %", "build wall s", "seconds", "+- %", "rays", "ns/ray",
       "B/primitive"},
      {},
      {}};
  for (const PrimitivePoint& p : points)
    table.rows.push_back(
        {fmt::format("{}", p.primitives), fmt::format("{:.2e}", p.build_seconds.median),
         range_text(p.build_seconds), fmt::format("{:.2e}", p.build_wall_seconds.median),
         seconds_text(p.render_seconds.median), range_text(p.render_seconds),
         fmt::format("{}", p.rays), nanoseconds_each(p.render_seconds.median, p.rays),
         bytes_each(p.bytes, p.primitives)});
  return table;
}

} // namespace

std::vector<Table> tables_of(const Scaling& s) {
  std::vector<Table> tables;
  if (!s.threads.empty()) tables.push_back(threads_table(s));
  if (!s.sizes.empty()) tables.push_back(pictures_table(s, s.sizes, "image size"));
  if (!s.samples.empty()) tables.push_back(pictures_table(s, s.samples, "samples"));
  if (!s.triangles.empty())
    tables.push_back(primitives_table(s, s.triangles, "a glass ball of triangles"));
  if (!s.lenses.empty()) tables.push_back(primitives_table(s, s.lenses, "lenses of two balls"));
  return tables;
}

} // namespace abbe::bench
