#pragma once

#include <span>
#include <vector>

namespace abbe {

/// The part of a round spot on the unit sphere, of this radius about a point that lies `distance`
/// from the pole, that is within `reach` of the pole; 0 to 1. All in radians, radius above 0 and
/// below pi / 2. The area common to two caps [Maz12].
[[nodiscard]] double cap_share(double radius, double distance, double reach);

/// Spreads flux over scattering angles as light does that comes evenly from a disc in the sky and
/// not from its centre alone. Cells divide 0 to pi evenly; within a cell flux is taken as spread
/// evenly over the sphere. No flux is lost.
class DiscBlur {
public:
  /// `radius` of the disc in radians; 0: nothing is spread.
  DiscBlur(std::size_t cells, double radius);

  void apply(std::span<double> flux) const;

private:
  /// The shares of one cell's flux that come to the cells from `first` on.
  struct Spread {
    std::size_t first = 0;
    std::vector<double> shares;
  };
  std::vector<Spread> spreads_; ///< by cell; empty: a point
};

} // namespace abbe
