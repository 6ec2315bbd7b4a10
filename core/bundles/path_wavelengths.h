#pragma once

#include "core/plan/plan.h"

#include <vector>

namespace abbe {

/// The wavelengths at which one camera path meets glass: one place inside every band, the same for
/// all bands, interfaces and Fresnel terms of the path. Indices are looked up once per path.
class PathWavelengths {
public:
  explicit PathWavelengths(const Plan& plan);

  /// Starts a path. `offset` from 0 to 1 is the place inside the bands.
  void begin_path(double offset);

  /// The medium's index in every band, as an array over bands.
  [[nodiscard]] const double* indices(MediumId medium);
  /// The same of a film or coat, an index into Plan::layers.
  [[nodiscard]] const double* layer_indices(int layer);
  /// The wavelengths (nm) themselves, per band.
  [[nodiscard]] const double* wavelengths_nm();
  /// The medium's index for a range of bands taken as one, at the path's place in that range.
  [[nodiscard]] double shared_index(MediumId medium, BandRange bands) const;

private:
  struct Entry {
    std::vector<double> indices;
    std::uint64_t path = 0; ///< the path they were looked up for
    bool constant = false;  ///< the same for every path
  };
  [[nodiscard]] Entry& entry(MediumId medium) {
    return entries_[medium.valid() ? medium.index() + 1 : 0];
  }
  [[nodiscard]] double wavelength_nm(int band) const {
    return plan_.lines.empty() ? plan_.grid.wavelength_nm(band, offset_)
                               : plan_.wavelength_nm(band, offset_);
  }
  const double* looked_up(Entry& entry, const IndexTable& index);

  const Plan& plan_;
  std::vector<Entry> entries_; ///< vacuum first, then the media, then the layers
  Entry wavelengths_nm_;
  double offset_ = 0.5;
  std::uint64_t path_ = 0;
};

} // namespace abbe
