#pragma once

#include "core/image/display.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace abbe {

/// Which ICC profiles files get. Version 2 is for programs that read no other.
enum class IccVersion { none, v2, v4 };

/// ICC profile, 4.3 or 2.1, of a display: its primaries, white and transfer function.
/// Every call gives the same bytes: the creation date is fixed, the profile id and the platform
/// are left zero ("not computed", "not identified"). (source: IEC99, ICC2010)
/// `none` gives no bytes. Errors: `std::runtime_error` when Little CMS cannot make it.
[[nodiscard]] std::vector<std::byte> icc_profile(const DisplayEncoding& encoding,
                                                 IccVersion version = IccVersion::v4);

/// What the profile is called: the space, and the transfer function when it is not the space's own.
[[nodiscard]] std::string profile_name(const DisplayEncoding& encoding);

/// Takes interleaved codes, as fractions of full scale, that the profile describes to linear sRGB,
/// white to white. Colours outside of it keep their negative components.
/// Errors: `std::runtime_error` for a profile that Little CMS cannot read or that is none of RGB.
void take_to_linear_srgb(std::vector<float>& rgb, std::span<const std::byte> profile);

} // namespace abbe
