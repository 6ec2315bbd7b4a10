#pragma once

#include "core/image/display.h"

#include <cstddef>
#include <string>
#include <vector>

namespace abbe {

/// ICC 4.3 profile of a display: its primaries, white and transfer function.
/// Every call gives the same bytes: the creation date is fixed, the profile id and the platform
/// are left zero ("not computed", "not identified"). (source: IEC99, ICC2010)
/// Errors: `std::runtime_error` when Little CMS cannot make it.
[[nodiscard]] std::vector<std::byte> icc_profile(const DisplayEncoding& encoding);

/// What the profile is called: the space, and the transfer function when it is not the space's own.
[[nodiscard]] std::string profile_name(const DisplayEncoding& encoding);

} // namespace abbe
