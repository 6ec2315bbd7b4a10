#pragma once

#include "spectral/color.h"
#include "spectral/curve.h"

#include <cstddef>
#include <variant>
#include <vector>

namespace abbe {

// Textures give a diffuse reflectance by the surface coordinates u and v; see
// geometry/world/surface_coordinates.h.

/// `across` x `up` fields in 0..1, which alternate between two reflectances. The field at the
/// origin has the first one. The pattern continues beyond 0..1.
struct CheckerTexture {
  double across = 1.0, up = 1.0;
  Curve first, second;
  friend bool operator==(const CheckerTexture&, const CheckerTexture&) = default;
};

/// Lines on the borders of `across` x `up` fields. A line is `width` fields wide (0 to 1), half of
/// it on each side of the border.
struct GridTexture {
  double across = 1.0, up = 1.0;
  double width = 0.1;
  Curve lines, fields;
  friend bool operator==(const GridTexture&, const GridTexture&) = default;
};

/// An image that fills 0..1, upright, and is repeated beyond.
struct ImageTexture {
  std::size_t image = 0; ///< index into Scene::images
  friend bool operator==(const ImageTexture&, const ImageTexture&) = default;
};

using Texture = std::variant<CheckerTexture, GridTexture, ImageTexture>;

/// An image of reflectances as linear sRGB, 0 to 1: the diffuse colours of ImageTexture.
struct ReflectanceImage {
  int width = 0, height = 0;
  std::vector<float> rgb; ///< three per texel, row by row, from the top left
  friend bool operator==(const ReflectanceImage&, const ReflectanceImage&) = default;
};

} // namespace abbe
