#pragma once

#include "core/bands/band_table.h"
#include "spectral/dispersion.h"

#include <vector>

namespace abbe {

/// The index of water at 20 degrees relative to air: [DM07] over [Cid96].
[[nodiscard]] Dispersion water_in_air();

/// Where sunlight goes that meets a spherical drop, per band: the power per steradian about a
/// scattering angle, over the power on the drop's disc. Over the whole sphere it sums to 1, less
/// what the orders above kLastOrder would add.
class DropPhaseFunction {
public:
  /// Rays of higher orders are left out; at water they carry 1e-4 of the light.
  static constexpr int kLastOrder = 12;
  /// Cells of 0.05 degrees, a tenth of the sun's disc.
  static constexpr std::size_t kCells = 3600;

  /// `wavelengths_nm[band]` are those whose mean the band gets. `disc_radius` of the source in the
  /// sky, in radians; 0: a point.
  DropPhaseFunction(const Dispersion& index, const std::vector<std::vector<double>>& wavelengths_nm,
                    double disc_radius, std::size_t cells = kCells);

  /// The share of the light that goes into a cell of scattering angles.
  [[nodiscard]] double flux(std::size_t cell, int band) const;

  /// Values per steradian and band at the scattering angle with this cosine, linear between the
  /// centres of cells: below[b] + share * (above[b] - below[b]).
  struct Place {
    const float* below;
    const float* above;
    float share;
    [[nodiscard]] float operator[](int band) const {
      return below[band] + share * (above[band] - below[band]);
    }
  };
  [[nodiscard]] Place at(double cosine) const;

private:
  [[nodiscard]] double solid_angle(std::size_t cell) const;

  std::size_t cells_, stride_;
  std::vector<float> values_; ///< one row of bands per cell
};

} // namespace abbe
