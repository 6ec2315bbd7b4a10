#include "core/bundles/path_wavelengths.h"

namespace abbe {

PathWavelengths::PathWavelengths(const Plan& plan)
    : plan_(plan), entries_(plan.media.size() + 1 + plan.layers.size()) {
  std::size_t next = 0;
  const auto prepare = [&](const IndexTable& index) {
    Entry& entry = entries_[next++];
    entry.constant = index.achromatic();
    entry.indices.resize(plan.stride, entry.constant ? index.at(kLowerNm) : 1.0);
  };
  prepare(plan.vacuum.index);
  for (const MediumPlan& medium : plan.media)
    prepare(medium.index);
  for (const IndexTable& layer : plan.layers)
    prepare(layer);
  wavelengths_nm_.indices.resize(plan.stride, 0.0);
}

void PathWavelengths::begin_path(double offset) {
  offset_ = offset;
  ++path_;
}

const double* PathWavelengths::looked_up(Entry& entry, const IndexTable& index) {
  if (!entry.constant && entry.path != path_) {
    const BandGrid& grid = plan_.grid;
    if (plan_.lines.empty())
      index.fill(grid.wavelength_nm(0, offset_), grid.width_nm(), grid.count(),
                 entry.indices.data());
    else
      for (int b = 0; b < grid.count(); ++b)
        entry.indices[static_cast<std::size_t>(b)] = index.at(wavelength_nm(b));
    entry.path = path_;
  }
  return entry.indices.data();
}

const double* PathWavelengths::indices(MediumId medium) {
  return looked_up(entry(medium), plan_.medium(medium).index);
}

const double* PathWavelengths::layer_indices(int layer) {
  const auto i = static_cast<std::size_t>(layer);
  return looked_up(entries_[plan_.media.size() + 1 + i], plan_.layers[i]);
}

const double* PathWavelengths::wavelengths_nm() {
  if (wavelengths_nm_.path != path_) {
    for (int b = 0; b < plan_.grid.count(); ++b)
      wavelengths_nm_.indices[static_cast<std::size_t>(b)] = wavelength_nm(b);
    wavelengths_nm_.path = path_;
  }
  return wavelengths_nm_.indices.data();
}

double PathWavelengths::shared_index(MediumId medium, BandRange bands) const {
  return plan_.medium(medium).index.at(
      plan_.shared_wavelength_nm(bands.first, bands.last, offset_));
}

} // namespace abbe
