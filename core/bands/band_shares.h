#pragma once

#include "core/bands/band_range.h"

#include <span>
#include <vector>

namespace abbe {

/// How a path that can follow only a few bands divides itself among all of them.
///
/// The bands are cut into n parts of equal share, and the same number u chooses one band of each,
/// so that the chosen bands form a lattice. With parts of equal width half of the rays would go
/// where the eye sees next to nothing. With parts by what the eye sees, weights would jump where it
/// sees little. Shares in proportion to the cube root of what it sees lie between, and have little
/// noise from 3 parts on; docs/decisions/bundles.md has the figures.
class BandShares {
public:
  BandShares() = default;
  /// `seen` is the weight of each band in the image; 0 for a band that carries no light.
  explicit BandShares(std::span<const double> seen);

  /// The share of a range. That of all bands is 1.
  [[nodiscard]] double of(BandRange range) const;
  /// The band at which a range of at least two bands is cut into halves of equal share, neither of
  /// them empty.
  [[nodiscard]] int middle(BandRange range) const { return place(range, 0.5); }
  /// The band before which this part of a range's share lies. Of two or more bands, neither side is
  /// empty.
  [[nodiscard]] int place(BandRange range, double part) const;

  /// A band that stands for a whole range, and its weight: 1 over the probability with which a
  /// number in [0, 1) chooses it.
  struct Kept {
    int band;
    float weight;
  };
  [[nodiscard]] Kept keep_one(BandRange range, double u) const;

private:
  std::vector<double> below_; ///< the share of all bands before each band; last, the share of all
};

} // namespace abbe
