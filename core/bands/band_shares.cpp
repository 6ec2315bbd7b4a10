#include "core/bands/band_shares.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// No band that carries light gets less than this part of the mean share, so that the ends of
/// spectra have little noise too.
constexpr double kLeastShare = 0.25;

std::size_t index(int band) {
  return static_cast<std::size_t>(band);
}

} // namespace

BandShares::BandShares(std::span<const double> seen) : below_(seen.size() + 1, 0.0) {
  double sum = 0.0;
  int live = 0;
  for (const double s : seen) {
    sum += std::cbrt(s);
    live += s > 0.0;
  }
  const double least = live > 0 ? kLeastShare * sum / live : 0.0;
  for (std::size_t b = 0; b < seen.size(); ++b)
    below_[b + 1] = below_[b] + (seen[b] > 0.0 ? std::max(std::cbrt(seen[b]), least) : 0.0);
  const double total = below_.back();
  if (total > 0.0)
    for (double& share : below_)
      share /= total;
}

double BandShares::of(BandRange range) const {
  return below_[index(range.last)] - below_[index(range.first)];
}

int BandShares::place(BandRange range, double part) const {
  const double target = below_[index(range.first)] + part * of(range);
  const auto begin = below_.begin() + range.first + 1, end = below_.begin() + range.last;
  auto found = std::lower_bound(begin, end, target);
  // Take the nearer of the two borders.
  if (found != begin && (found == end || *found - target > target - *(found - 1))) --found;
  return static_cast<int>(found - below_.begin());
}

BandShares::Kept BandShares::keep_one(BandRange range, double u) const {
  const double share = of(range);
  if (!(share > 0.0)) return {range.first, static_cast<float>(range.size())};
  const double target = below_[index(range.first)] + u * share;
  const auto begin = below_.begin() + range.first + 1, end = below_.begin() + range.last;
  // Take the first band that ends beyond the target, but none without a share.
  int band = static_cast<int>(std::upper_bound(begin, end, target) - below_.begin()) - 1;
  while (band > range.first && of({band, band + 1}) == 0.0)
    --band;
  return {band, static_cast<float>(share / of({band, band + 1}))};
}

} // namespace abbe
