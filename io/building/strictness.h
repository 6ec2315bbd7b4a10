#pragma once

#include <cstdint>

namespace abbe {

/// Whether what a reader of another program's scenes does not understand is an error or a warning.
enum class Strictness : std::uint8_t { strict, lenient };

} // namespace abbe
