#include "core/image/metadata.h"

#include "core/film/lost_light.h"
#include "core/scene/setting_table.h"

#include <fmt/format.h>

#include <span>
#include <utility>

namespace abbe {
namespace {

/// The rows that picture files name, as far as they matter.
template <class Row, class Settings>
Metadata metadata_of(std::span<const Row> table, const Settings& settings) {
  Metadata data;
  for (const Row& row : table)
    if (!row.metadata.empty() && (row.matters == nullptr || row.matters(settings)))
      data.emplace_back(fmt::format("abbe/{}", row.metadata), value_text(row, settings));
  return data;
}

} // namespace

Metadata render_metadata(const Plan& plan) {
  return metadata_of(render_setting_table(), plan.settings);
}

Metadata lost_metadata(const Film& film) {
  const auto lost = lost_share(film);
  if (!lost) return {};
  return {{"abbe/depthTook", fmt::format("{:.3g} +- {:.2g}", lost->share, lost->error)}};
}

Metadata film_metadata(const Film& film) {
  double samples = 0.0;
  for_each_pixel(film.window(), [&](int x, int y) { samples += film.samples(x, y); });
  samples /= static_cast<double>(film.window().pixel_count());
  Metadata data{{"abbe/samplesTaken", fmt::format("{:.6g}", samples)},
                {"abbe/units", "radiance; that of the equal-energy spectrum of value 1 is Y = 1"}};
  for (auto& entry : lost_metadata(film))
    data.push_back(std::move(entry));
  return data;
}

Metadata display_metadata(const DisplaySettings& settings, Observer observer) {
  DisplaySettings seen = settings;
  if (seen.white_point) seen.white_point = WhitePoint::at(seen.white_point->seen_by(observer));
  return metadata_of(display_setting_table(), seen);
}

} // namespace abbe
