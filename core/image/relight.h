#pragma once

#include "core/film/film.h"
#include "core/image/image.h"
#include "core/plan/plan.h"
#include "spectral/curve.h"

#include <span>
#include <string>
#include <vector>

namespace abbe {

/// Rows of what a group of lights brings to the film of a relightable rendering under light of
/// equal energy and of value 1: its part of the light, for each band. The preview is its colour
/// under that light.
[[nodiscard]] SpectralImage develop_unit(const Film& film, const Plan& plan,
                                         const std::string& group, const PixelWindow& rows);

/// What the bands of a group's light become under a lamp: X, Y and Z for each band.
class Lamp {
public:
  /// `spectrum` is the value by wavelength that takes the place of 1.
  Lamp(const BandGrid& grid, const Curve& spectrum, Observer observer);

  /// `unit` has one value for each band.
  [[nodiscard]] Xyz color(std::span<const float> unit) const;

private:
  std::vector<Xyz> weights_;
};

} // namespace abbe
