#pragma once

#include <cstddef>
#include <vector>

namespace abbe {

/// ICC 4.3 profile of sRGB: Rec. 709 primaries, D65, the sRGB transfer function.
/// Every call gives the same bytes: the creation date is fixed, the profile id and the platform
/// are left zero ("not computed", "not identified"). (source: IEC99, ICC2010)
/// Errors: `std::runtime_error` when Little CMS cannot make it.
[[nodiscard]] std::vector<std::byte> srgb_profile();

/// The same primaries and white with transfer function y = x.
[[nodiscard]] std::vector<std::byte> linear_srgb_profile();

} // namespace abbe
