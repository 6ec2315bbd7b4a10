#include "io/pages/packed_tile.h"

#include "tests/catch.h"

#include <zlib.h>

#include <cmath>
#include <limits>
#include <string_view>

using namespace abbe;

namespace {

/// What base64 stands for, read the slow way.
std::string bytes_of(const std::string& text) {
  const std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned held = 0, bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    held = held << 6U | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 255U);
  }
  return bytes;
}

std::string inflated(const std::string& stream) {
  const std::string packed = bytes_of(stream);
  std::string bytes(100000, '\0');
  uLongf size = bytes.size();
  REQUIRE(::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
  bytes.resize(size);
  return bytes;
}

} // namespace

TEST_CASE("a tile's bands are codes within the range of their pixel, as differences") {
  // Three pixels of two bands. The second goes below 0, so that its range begins there.
  const TileValues tile{3, std::vector<float>(9, 0.0F), {0.5F, 1.0F, -1.0F, 3.0F, 0.0F, 0.0F}, {}};
  const std::vector<std::string> streams = packed_streams(tile, BandBits::eight);
  REQUIRE(streams.size() == 4); // colours, ranges, two bands
  CHECK(inflated(streams[0]) == std::string(36, '\0'));
  // -1 is 0xbf800000, 1 is 0x3f800000, 3 is 0x40400000. First bytes come first.
  const std::string low_and_high("\0\0\0\0\0\0\0\x80\0\0\xbf\0"
                                 "\0\0\0\0\0\0\x80\x40\0\x3f\x40\0",
                                 24);
  CHECK(inflated(streams[1]) == low_and_high);
  CHECK(inflated(streams[2]) == std::string("\x80\x80\0", 3)); // 128, 0, 0: + 128, - 128, 0
  CHECK(inflated(streams[3]) == std::string("\xff\0\x01", 3)); // 255, 255, 0: + 255, 0, - 255
}

TEST_CASE("codes of 16 bits have their high bytes first") {
  const TileValues tile{2, std::vector<float>(6, 1.0F), {1.0F, 0.5F, 0.0F, 2.0F}, {}};
  const std::vector<std::string> streams = packed_streams(tile, BandBits::sixteen);
  CHECK(inflated(streams[2]) == std::string("\xff\0\xff\x01", 4)); // 0xffff, 0
  CHECK(inflated(streams[3]) == std::string("\x80\x7f\0\xff", 4)); // 0x8000, 0xffff: + 0x7fff
}

TEST_CASE("a band without a number leaves its pixel without a range") {
  const float none = std::numeric_limits<float>::infinity();
  const TileValues tile{1, {0.0F, 0.0F, 0.0F}, {1.0F, none}, {}};
  const std::string ranges = inflated(packed_streams(tile, BandBits::eight)[1]);
  CHECK(ranges == std::string("\0\0\xc0\x7f\0\0\xc0\x7f", 8)); // not a number, twice
}

TEST_CASE("layers come last, a plane for each channel") {
  const TileValues tile{2, std::vector<float>(6, 0.0F), {}, {1.0F, 3.0F, 1.0F, 3.0F}};
  const std::vector<std::string> streams = packed_streams(tile, BandBits::eight);
  REQUIRE(streams.size() == 3);
  CHECK(inflated(streams[1]) == std::string("\0\0\0\0\x80\x80\x3f\x3f", 8));
  CHECK(inflated(streams[2]) == std::string("\0\0\0\0\x40\x40\x40\x40", 8));
}

TEST_CASE("the largest error is half a step of the codes") {
  CHECK(largest_error(BandBits::eight) == Approx(1.0 / 510.0));
  CHECK(largest_error(BandBits::sixteen) == Approx(1.0 / 131070.0));
}
