#include "core/plan/plan.h"

namespace abbe {
namespace {

/// The line at the fraction `offset` (0..1) of the power of `lines`, which are not empty.
double line_wavelength_nm(const std::vector<SpectralLine>& lines, double offset) {
  double below = 0.0;
  for (const SpectralLine& line : lines) {
    below += line.power;
    if (offset < below) return line.nm;
  }
  return lines.back().nm;
}

} // namespace

double Plan::wavelength_nm(int band, double offset) const {
  if (!lines.empty())
    if (const auto& own = lines[static_cast<std::size_t>(band)]; !own.empty())
      return line_wavelength_nm(own, offset);
  return grid.wavelength_nm(band, offset);
}

} // namespace abbe
