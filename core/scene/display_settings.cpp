#include "core/scene/display_settings.h"

namespace abbe {

WhitePoint WhitePoint::of_light(const Curve& spectrum) {
  return {chromaticity(to_xyz(spectrum, Observer::cie1931_2deg)),
          chromaticity(to_xyz(spectrum, Observer::cie1964_10deg))};
}

} // namespace abbe
