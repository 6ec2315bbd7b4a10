#include "io/pages/packed_tile.h"

#include "io/files/deflate.h"
#include "io/text/base64.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace abbe {
namespace {

std::uint32_t most_code(BandBits bits) {
  return (1U << static_cast<unsigned>(bits)) - 1U;
}

/// The bytes of floats, little-endian, by their place within the float.
void add_plane(std::string& bytes, const std::vector<float>& values) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    for (const float value : values)
      bytes += static_cast<char>(std::bit_cast<std::uint32_t>(value) >> shift);
}

/// Each `stride`th value from `first` on.
std::vector<float> plane(const std::vector<float>& values, std::size_t first, std::size_t stride) {
  std::vector<float> picked;
  for (std::size_t i = first; i < values.size(); i += stride)
    picked.push_back(values[i]);
  return picked;
}

struct Range {
  float low = 0.0F, high = 0.0F;
};

Range range_of(const float* first, const float* last) {
  Range range;
  for (const float* value = first; value != last; ++value) {
    if (!std::isfinite(*value))
      return {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::quiet_NaN()};
    range = {std::min(range.low, *value), std::max(range.high, *value)};
  }
  return range;
}

std::uint32_t code_of(float value, const Range& range, BandBits bits) {
  const double width = static_cast<double>(range.high) - static_cast<double>(range.low);
  if (!(width > 0.0)) return 0; // also where there is no range
  const double part = (static_cast<double>(value) - static_cast<double>(range.low)) / width;
  return static_cast<std::uint32_t>(std::lround(part * most_code(bits)));
}

std::string code_bytes(const std::vector<std::uint32_t>& codes, BandBits bits) {
  std::string bytes;
  for (int shift = static_cast<int>(bits) - 8; shift >= 0; shift -= 8) {
    std::uint32_t before = 0;
    for (const std::uint32_t code : codes) {
      bytes += static_cast<char>((code - before) >> static_cast<unsigned>(shift));
      before = code;
    }
  }
  return bytes;
}

} // namespace

double largest_error(BandBits bits) {
  return 0.5 / most_code(bits);
}

std::vector<std::string> packed_streams(const TileValues& tile, BandBits bits) {
  std::vector<std::string> streams;
  const auto add = [&streams](std::string_view bytes) {
    streams.push_back(base64(deflated(bytes)));
  };
  std::string bytes;
  for (std::size_t k = 0; k < 3; ++k)
    add_plane(bytes, plane(tile.rgb, k, 3));
  add(bytes);
  const std::size_t bands = tile.bands.size() / tile.pixels;
  if (bands > 0) {
    std::vector<Range> ranges;
    std::vector<float> low, high;
    for (std::size_t pixel = 0; pixel < tile.pixels; ++pixel) {
      const float* const first = tile.bands.data() + pixel * bands;
      ranges.push_back(range_of(first, first + bands));
      low.push_back(ranges.back().low);
      high.push_back(ranges.back().high);
    }
    bytes.clear();
    add_plane(bytes, low);
    add_plane(bytes, high);
    add(bytes);
    std::vector<std::uint32_t> codes(tile.pixels);
    for (std::size_t band = 0; band < bands; ++band) {
      for (std::size_t pixel = 0; pixel < tile.pixels; ++pixel)
        codes[pixel] = code_of(tile.bands[pixel * bands + band], ranges[pixel], bits);
      add(code_bytes(codes, bits));
    }
  }
  const std::size_t channels = tile.layers.size() / tile.pixels;
  for (std::size_t channel = 0; channel < channels; ++channel) {
    bytes.clear();
    add_plane(bytes, plane(tile.layers, channel, channels));
    add(bytes);
  }
  return streams;
}

} // namespace abbe
