#include "core/path_wavelengths.h"

namespace abbe {

PathWavelengths::PathWavelengths(const Plan& plan) : plan_(plan), entries_(plan.media.size() + 1) {
  for (Entry& entry : entries_)
    entry.indices.resize(plan.stride, 1.0);
}

void PathWavelengths::begin_path(double offset) {
  offset_ = offset;
  ++path_;
}

const double* PathWavelengths::indices(MediumId medium) {
  Entry& e = entry(medium);
  if (e.path != path_) {
    const IndexTable& index = plan_.medium(medium).index;
    const bool lines = !plan_.lines.empty();
    for (int b = 0; b < plan_.grid.count(); ++b)
      e.indices[static_cast<std::size_t>(b)] =
          index.at(lines ? plan_.wavelength_nm(b, offset_) : plan_.grid.wavelength_nm(b, offset_));
    e.path = path_;
  }
  return e.indices.data();
}

double PathWavelengths::shared_index(MediumId medium, int first, int last) const {
  return plan_.medium(medium).index.at(plan_.shared_wavelength_nm(first, last, offset_));
}

} // namespace abbe
