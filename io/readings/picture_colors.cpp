#include "io/readings/picture_colors.h"

#include "core/scene/user_error.h"
#include "spectral/band_colors.h"

#include <fmt/format.h>

namespace abbe {

PictureColors::PictureColors(const PictureHeader& header, const ColorSource& source,
                             const std::string& file)
    : observer_(source.observer.value_or(Observer::cie1931_2deg)) {
  const bool has_bands = !header.wavelengths_nm.empty();
  if (source.observer && !has_bands)
    throw UserError(fmt::format("{}: it has no bands that an observer could see: render them with "
                                "--spectral",
                                file));
  if (!has_bands && !header.has_color)
    throw UserError(fmt::format("{}: it has neither channels R, G and B, nor Y, nor bands", file));
  if (has_bands && (source.observer || source.prefer_bands || !header.has_color))
    bands_ = colors_of_bands(header.wavelengths_nm, observer_);
}

Xyz PictureColors::color(const Picture& picture, std::size_t pixel) const {
  if (bands_.empty()) {
    const float* const rgb = picture.rgb.data() + 3 * pixel;
    return to_xyz(LinearRgb{rgb[0], rgb[1], rgb[2]});
  }
  Xyz sum;
  for (std::size_t band = 0; band < bands_.size(); ++band)
    sum += bands_[band] * static_cast<double>(picture.bands[pixel * bands_.size() + band]);
  return sum;
}

} // namespace abbe
