#pragma once

#include "core/plan/plan.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace abbe {

/// Builds the list of sources and their accumulators. At the standard's own sampling a source's
/// spectrum can be multiplied in per band, so one accumulator serves all; elsewhere the product of
/// spectrum and observer is folded per source, and equal spectra share an accumulator. So it is for
/// spectral lines, whose colour is that of their wavelength and not of their band.
class SourcePlanner {
public:
  explicit SourcePlanner(Plan& plan);

  /// Returns the index of the source in Plan::sources.
  int add(const Curve& spectrum);

private:
  /// The place of an equal spectrum in spectra_; it is added where there is none.
  std::size_t find_or_add(const Curve& spectrum);
  void add_accumulator(const Curve& spectrum);

  Plan& plan_;
  bool per_band_;
  std::vector<Curve> spectra_;
  std::unordered_multimap<std::size_t, std::size_t> known_; ///< into spectra_, by checksum
};

} // namespace abbe
