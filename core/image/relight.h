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

/// How many times the noise is, in luminance, that a path leaves which follows one band at a time,
/// when it was rendered under light of equal energy and not under this spectrum. It is the most
/// that a change of the lamp can do where glass parts the bands. Infinite where a rendering under
/// the spectrum would have no such noise.
[[nodiscard]] double noise_of_change(const BandGrid& grid, const Curve& spectrum,
                                     Observer observer);

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
