#include "core/image/scene_linear_space.h"

#include "spectral/adaptation.h"

#include <algorithm>
#include <limits>

namespace abbe {
namespace {

/// As colourspaces.csv calls it.
const char* name(SceneLinearSpace space) {
  switch (space) {
  case SceneLinearSpace::rec709:
    return "rec709";
  case SceneLinearSpace::acescg:
    return "acescg";
  case SceneLinearSpace::aces2065_1:
    return "aces2065-1";
  case SceneLinearSpace::rec2020:
    return "rec2020";
  }
  return "";
}

} // namespace

ColorSpace space_of(SceneLinearSpace space) {
  return find_color_space(name(space)).value();
}

Matrix3 matrix_to(SceneLinearSpace space) {
  const ColorSpace target = space_of(space);
  const Matrix3 adaptation =
      bradford_adaptation(to_xyz(kSrgbWhite, 1.0), to_xyz(target.white, 1.0));
  return multiply(inverse(rgb_to_xyz_matrix(target.primaries, target.white)), adaptation);
}

float as_float(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));
}

} // namespace abbe
