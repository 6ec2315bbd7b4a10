#include "spectral/band_colors.h"

#include <cmath>
#include <cstddef>

namespace abbe {
namespace {

/// True where these are the centres of as many bands, to the digits in which files write them.
bool is_grid(std::span<const double> nm) {
  if (nm.empty() || nm.size() > static_cast<std::size_t>(BandGrid::kMaxCount)) return false;
  const BandGrid grid(static_cast<int>(nm.size()));
  for (std::size_t i = 0; i < nm.size(); ++i)
    if (!(std::abs(nm[i] - grid.center_nm(static_cast<int>(i))) < 1e-5)) return false;
  return true;
}

/// The spectrum that is 1 at one of the wavelengths and 0 at all others.
Curve share_of(std::span<const double> nm, std::size_t band) {
  constexpr double kHalfOfOne = 2.5;
  const bool first = band == 0, last = band + 1 == nm.size();
  const double before = first ? 0.0 : nm[band] - nm[band - 1];
  const double after = last ? 0.0 : nm[band + 1] - nm[band];
  std::vector<double> at, values;
  if (first) {
    at.push_back(nm[band] - (last ? kHalfOfOne : 0.5 * after));
    values.push_back(1.0);
  } else {
    at.push_back(nm[band - 1]);
    values.push_back(0.0);
  }
  at.push_back(nm[band]);
  values.push_back(1.0);
  if (last) {
    at.push_back(nm[band] + (first ? kHalfOfOne : 0.5 * before));
    values.push_back(1.0);
  } else {
    at.push_back(nm[band + 1]);
    values.push_back(0.0);
  }
  return Curve::table(std::move(at), std::move(values), Outside::zero);
}

} // namespace

std::vector<Xyz> colors_of_bands(std::span<const double> nm, Observer observer) {
  if (is_grid(nm))
    return band_weights(BandGrid(static_cast<int>(nm.size())), Curve::constant(1.0), observer);
  std::vector<Xyz> colors(nm.size());
  for (std::size_t band = 0; band < nm.size(); ++band) // in cells of 1 nm
    for (const Xyz& cell :
         band_weights(BandGrid(BandGrid::kMaxCount), share_of(nm, band), observer))
      colors[band] += cell;
  return colors;
}

} // namespace abbe
