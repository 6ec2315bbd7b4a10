#include "spectral/line_lamp.h"

#include "spectral/band_grid.h"
#include "spectral/observer.h"

#include <stdexcept>

namespace abbe {
namespace {

Curve scaled_to_unit_luminance(const Curve& lines) {
  return lines.scaled(1.0 / to_xyz(lines).y);
}

} // namespace

Curve line_lamp(double lambda_nm) {
  if (!(lambda_nm >= sample_nm(0) && lambda_nm <= sample_nm(kSampleCount - 1)))
    throw std::invalid_argument("a line of light lies between 380 and 780 nm");
  return scaled_to_unit_luminance(Curve::lines({{lambda_nm, 1.0}}));
}

Curve sodium_lamp() {
  return scaled_to_unit_luminance(Curve::lines({{588.9950, 2.0}, {589.5924, 1.0}}));
}

} // namespace abbe
