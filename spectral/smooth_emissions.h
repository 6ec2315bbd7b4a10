#pragma once

#include "spectral/rgb_spectrum.h"

#include <vector>

namespace abbe {

/// `smooth_emission` for whole images: linear between solutions that are found once, in about
/// 0.2 s. Greys are exact; the colour is met to 1e-3 of the largest component, and to 3e-5 on
/// average. (source: measured)
class SmoothEmissions {
public:
  SmoothEmissions();

  /// Negative components count as 0.
  [[nodiscard]] SmoothCurve of(const LinearRgb& color) const;

private:
  [[nodiscard]] const Vector3& node(int largest, int i, int j) const;

  std::vector<Vector3> nodes_; ///< by the largest component, then the other two relative to it
};

} // namespace abbe
