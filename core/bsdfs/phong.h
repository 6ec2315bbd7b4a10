#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/incidence.h"

#include <algorithm>
#include <cmath>

namespace abbe {

/// The thesis's highlight, which adds to Lambert's part: Phong's with Blinn's half vector. It has
/// no factor of the cosine; see docs/decisions/materials-and-light.md.
struct Phong {
  BandTable reflectance; ///< where it is zero, there is no highlight
  float exponent = 1.0f;

  [[nodiscard]] bool present() const { return !reflectance.zero(); }
  /// The highlight's strength, by the cosine between the half vector and the normal.
  [[nodiscard]] double strength(double cos_half) const {
    return std::pow(std::max(0.0, cos_half), static_cast<double>(exponent));
  }
  /// Adds the highlight to `f_cos` and returns the pdf with which `sample` picks `wi`.
  double add(const Incidence& in, const dvec3& wi, float* f_cos) const;
  [[nodiscard]] dvec3 sample(const Incidence& in, const dvec2& u) const;
};

} // namespace abbe
