#pragma once

#include "core/bands/band_range.h"

#include <span>
#include <vector>

namespace abbe {

/// How a path that can follow a few bands alone divides itself among all of them.
///
/// One band for each of n parts of equal share, each kept by the same number u, is a lattice on the
/// bands. Parts of equal width would spend half their rays where the eye sees next to nothing;
/// parts by what the eye sees have weights that jump where it sees little. Shares in proportion to
/// the cube root of that lie between, and have little noise from 3 parts on;
/// docs/decisions/bundles.md has the figures.
class BandShares {
public:
  BandShares() = default;
  /// `seen` tells what each band counts in the picture; 0 for one that carries no light.
  explicit BandShares(std::span<const double> seen);

  /// The share of a range; that of all bands is 1.
  [[nodiscard]] double of(BandRange range) const;
  /// Where a range of two bands at least falls into halves of equal share, neither of them empty.
  [[nodiscard]] int middle(BandRange range) const { return place(range, 0.5); }
  /// Where this part of a range's share lies before. Of two bands or more, neither side is empty.
  [[nodiscard]] int place(BandRange range, double part) const;

  /// A band that stands for all of a range, and the weight that makes up for the others: 1 over the
  /// chance of choosing it by a number in [0, 1).
  struct Kept {
    int band;
    float weight;
  };
  [[nodiscard]] Kept keep_one(BandRange range, double u) const;

private:
  std::vector<double> below_; ///< the share of all bands before each one, and that of all
};

} // namespace abbe
