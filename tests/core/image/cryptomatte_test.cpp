#include "core/image/cryptomatte.h"

#include "tests/catch.h"

#include <bit>
#include <string>
#include <vector>

using namespace abbe;

// Published values of MurmurHash3_x86_32 with the seed 0, of all lengths modulo 4.
TEST_CASE("names are hashed by MurmurHash3") {
  CHECK(murmur3_32("") == 0u);
  CHECK(murmur3_32("test") == 0xba6bd213u);
  CHECK(murmur3_32("Hello, world!") == 0xc0363e43u);
  CHECK(murmur3_32("The quick brown fox jumps over the lazy dog") == 0x2e4ff723u);
}

TEST_CASE("ids are ordinary floats, and the names of layers have the keys of the standard") {
  for (int i = 0; i < 5000; ++i) {
    const std::uint32_t id = cryptomatte_id("object" + std::to_string(i));
    const std::uint32_t exponent = id >> 23 & 255;
    REQUIRE(exponent != 0);
    REQUIRE(exponent != 255);
  }
}

// Counts of 5, 3 and 2 of 10 samples; the things of one name, 1 and 2, are one.
TEST_CASE("ranks are the shares of the things that cover a pixel, the largest first") {
  Film film({0, 0, 1, 1}, {{.name = "object", .kind = LayerKind::ids}});
  const LayerId layer = *film.find("object");
  for (std::uint32_t s = 0; s < 10; ++s) {
    const Film::Place place = film.count({0, 0, s, s < 9});
    if (s < 9) film.add_id(layer, place, s < 4 ? 0 : s < 7 ? 1 : 2);
  }
  const std::vector<std::string> names{"ball", "box", "box"};
  const auto channels = cryptomatte_channels(film, layer, film.window(), names, "CryptoObject");
  REQUIRE(channels.size() == 2 * kCryptomatteRanks);
  CHECK(channels[0].name == "CryptoObject00.R");
  CHECK(channels[5].name == "CryptoObject01.G");
  CHECK(std::bit_cast<std::uint32_t>(channels[0].values[0]) == cryptomatte_id("box"));
  CHECK(channels[1].values[0] == 0.5f);
  CHECK(std::bit_cast<std::uint32_t>(channels[2].values[0]) == cryptomatte_id("ball"));
  CHECK(channels[3].values[0] == 0.4f);
  CHECK(channels[4].values[0] == 0.0f);
  CHECK(channels[5].values[0] == 0.0f);
}

TEST_CASE("the manifest gives each name its id, as JSON") {
  const std::vector<std::string> names{"a\"b", "ball", "ball"};
  const Metadata data = cryptomatte_metadata(names, "CryptoObject");
  REQUIRE(data.size() == 4);
  CHECK(data[0].second == "CryptoObject");
  CHECK(data[1].second == "MurmurHash3_32");
  CHECK(data[2].second == "uint32_to_float32");
  CHECK(data[3].second.starts_with("{\"a\\\"b\":\""));
  CHECK(data[3].second.ends_with("\"}"));
  CHECK(data[0].first.starts_with("cryptomatte/"));
  CHECK(data[0].first.size() == std::string("cryptomatte/1234567/name").size());
}
