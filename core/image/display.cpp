#include "core/image/display.h"

#include "spectral/adaptation.h"

#include <cmath>

namespace abbe {

DisplayEncoding encoding_of(const DisplaySettings& settings) {
  return {settings.space, settings.transfer.value_or(settings.space.transfer)};
}

DisplayTransform::DisplayTransform(const DisplaySettings& settings, Observer observer)
    : gamut_(settings.gamut), tone_(settings.tone), transfer_(encoding_of(settings).transfer) {
  const Matrix3 to_xyz_of_rgb = rgb_to_xyz_matrix(settings.space.primaries, settings.space.white);
  luminance_weights_ = to_xyz_of_rgb[1];
  const double gain = std::exp2(settings.exposure_ev);
  to_rgb_ = multiply(inverse(to_xyz_of_rgb), diagonal({gain, gain, gain}));
  if (settings.white_point) {
    const Xyz from = to_xyz(settings.white_point->seen_by(observer), 1.0);
    to_rgb_ =
        multiply(to_rgb_, adaptation(from, to_xyz(settings.space.white, 1.0), settings.adaptation));
  }
}

LinearRgb DisplayTransform::unclipped(const Xyz& color) const {
  const Vector3 rgb = multiply(to_rgb_, Vector3{color.x, color.y, color.z});
  return with_tone({rgb[0], rgb[1], rgb[2]}, tone_, luminance_weights_);
}

LinearRgb DisplayTransform::linear(const Xyz& color) const {
  return map_to_gamut(unclipped(color), gamut_, luminance_weights_);
}

DisplayRgb DisplayTransform::encoded(const LinearRgb& linear) const {
  return encode(transfer_, linear);
}

} // namespace abbe
