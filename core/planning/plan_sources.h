#pragma once

#include "core/plan/plan.h"

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
  void add_accumulator(const Curve& spectrum);

  Plan& plan_;
  bool per_band_;
  std::vector<Curve> spectra_;
};

} // namespace abbe
