#pragma once

#include "core/film/film.h"
#include "core/image/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

// Cryptomatte 1.2.0: which things cover a pixel, and how much of it, as pairs of an id and a share.
// (source: Friedman2015)

/// MurmurHash3_x86_32 of the bytes, with the seed 0. (source: Appleby's public domain code)
[[nodiscard]] std::uint32_t murmur3_32(std::string_view bytes);

/// The id of a name: its hash, changed where the float with the same bits would be no ordinary
/// number.
[[nodiscard]] std::uint32_t cryptomatte_id(std::string_view name);

/// So many things of a pixel are written: those that cover the most of it.
inline constexpr std::size_t kCryptomatteRanks = 6;

/// The channels of a layer of ids: `type`00.R, .G, .B, .A and so on, two ranks in each. `names` are
/// those of the layer's numbers; things of one name are one thing.
[[nodiscard]] std::vector<ImageChannel> cryptomatte_channels(const Film& film, LayerId layer,
                                                             const PixelWindow& part,
                                                             std::span<const std::string> names,
                                                             std::string_view type);
/// The metadata of the layer, with the manifest of all names.
[[nodiscard]] Metadata cryptomatte_metadata(std::span<const std::string> names,
                                            std::string_view type);

} // namespace abbe
