#pragma once

#include "io/images/picture.h"

#include <string>
#include <vector>

namespace abbe {

/// How many bits a page keeps of the value of a band.
enum class BandBits : std::uint8_t { eight = 8, sixteen = 16 };

/// The largest error of a value of a band, as a part of the range of its pixel's values.
[[nodiscard]] double largest_error(BandBits bits);

/// Values of a tile, side by side by pixel.
struct TileValues {
  std::size_t pixels = 0;
  std::vector<float> rgb, bands, layers; ///< those that a picture has none of are empty
};

/// The streams of a tile, compressed and in base64, in the order in which the page's script
/// (io/pages/view/tiles.js) takes them apart:
///
/// - the colours: planes of red, green and blue;
/// - with bands, the range of each pixel: planes of its lowest value, or 0 where that is less, and
///   of its highest;
/// - each band: codes from 0 for the lowest to the most that the bits hold for the highest, each as
///   the difference to the code of the pixel before it, high bytes before low bytes;
/// - each channel of the layers: a plane.
///
/// A plane of floats has all first bytes of its values, then all second ones and so on, since bytes
/// of one kind compress better. A pixel that has a band without a number has no range.
[[nodiscard]] std::vector<std::string> packed_streams(const TileValues& tile, BandBits bits);

} // namespace abbe
