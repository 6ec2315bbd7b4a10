#include "core/image/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <set>
#include <utility>

namespace abbe {
namespace {

/// A string of JSON, without its quotes.
std::string escaped(std::string_view text) {
  std::string json;
  for (const char c : text) {
    if (c == '"' || c == '\\')
      json += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20)
      json += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      json += c;
  }
  return json;
}

} // namespace

std::uint32_t murmur3_32(std::string_view bytes) {
  constexpr std::uint32_t c1 = 0xcc9e2d51, c2 = 0x1b873593;
  const auto scrambled = [](std::uint32_t k) { return std::rotl(k * c1, 15) * c2; };
  std::uint32_t h = 0;
  std::size_t i = 0;
  for (; i + 4 <= bytes.size(); i += 4) {
    std::uint32_t k = 0;
    for (std::size_t j = 4; j-- > 0;)
      k = k << 8 | static_cast<unsigned char>(bytes[i + j]);
    h = std::rotl(h ^ scrambled(k), 13) * 5 + 0xe6546b64;
  }
  std::uint32_t tail = 0;
  for (std::size_t j = bytes.size(); j-- > i;)
    tail = tail << 8 | static_cast<unsigned char>(bytes[j]);
  h ^= scrambled(tail);
  h ^= static_cast<std::uint32_t>(bytes.size());
  h = (h ^ h >> 16) * 0x85ebca6b;
  h = (h ^ h >> 13) * 0xc2b2ae35;
  return h ^ h >> 16;
}

std::uint32_t cryptomatte_id(std::string_view name) {
  const std::uint32_t hash = murmur3_32(name), exponent = hash >> 23 & 255;
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

std::vector<ImageChannel> cryptomatte_channels(const Film& film, LayerId layer,
                                               const PixelWindow& part,
                                               std::span<const std::string> names,
                                               std::string_view type) {
  std::vector<std::uint32_t> ids;
  for (const std::string& name : names)
    ids.push_back(cryptomatte_id(name));
  std::vector<ImageChannel> channels;
  for (std::size_t i = 0; i < 2 * kCryptomatteRanks; ++i)
    channels.push_back({fmt::format("{}{:02}.{}", type, i / 4, "RGBA"[i % 4]), {}});
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranks; // id, count
  for_each_pixel(part, [&](int x, int y) {
    ranks.clear();
    for (const auto& [number, count] : film.layer(layer).ids().of(film.window().index(x, y))) {
      if (number >= ids.size()) continue; // a made-up state; a rendering has no such number
      const std::uint32_t id = ids[number];
      const auto same = std::ranges::find(ranks, id, [](const auto& r) { return r.first; });
      if (same == ranks.end())
        ranks.emplace_back(id, count);
      else
        same->second += count;
    }
    std::ranges::sort(ranks, [](const auto& a, const auto& b) {
      return a.second != b.second ? a.second > b.second : a.first < b.first;
    });
    for (std::size_t r = 0; r < kCryptomatteRanks; ++r) {
      const bool there = r < ranks.size();
      channels[2 * r].values.push_back(there ? std::bit_cast<float>(ranks[r].first) : 0.0f);
      channels[2 * r + 1].values.push_back(there ? static_cast<float>(ranks[r].second) /
                                                       static_cast<float>(film.samples(x, y))
                                                 : 0.0f);
    }
  });
  return channels;
}

Metadata cryptomatte_metadata(std::span<const std::string> names, std::string_view type) {
  const std::set<std::string> sorted(names.begin(), names.end());
  std::string manifest;
  for (const std::string& name : sorted)
    manifest += fmt::format("{}\"{}\":\"{:08x}\"", manifest.empty() ? "{" : ",", escaped(name),
                            cryptomatte_id(name));
  manifest += manifest.empty() ? "{}" : "}";
  const std::string key =
      "cryptomatte/" + fmt::format("{:08x}", murmur3_32(type)).substr(0, 7) + "/";
  return {{key + "name", std::string(type)},
          {key + "hash", "MurmurHash3_32"},
          {key + "conversion", "uint32_to_float32"},
          {key + "manifest", manifest}};
}

} // namespace abbe
