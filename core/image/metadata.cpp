#include "core/image/metadata.h"

#include "core/film/lost_light.h"
#include "core/scene/setting_table.h"

#include <fmt/format.h>

#include <span>

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

Metadata display_metadata(const DisplaySettings& settings, Observer observer) {
  DisplaySettings seen = settings;
  if (seen.white_point) seen.white_point = WhitePoint::at(seen.white_point->seen_by(observer));
  return metadata_of(display_setting_table(), seen);
}

} // namespace abbe
