#pragma once

#include <cstdint>
#include <optional>

namespace abbe {

/// Throws UserError where a rendering needs more memory than the limit, which is what is available
/// where the user gives none. It tells both. A limit that the user gives is one on all that the
/// process takes: what it holds already, the scene above all, counts too.
void check_memory(std::uint64_t need, std::optional<double> limit_gib);

} // namespace abbe
