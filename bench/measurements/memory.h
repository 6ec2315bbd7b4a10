#pragma once

#include <cstddef>
#include <optional>

namespace abbe::bench {

/// The bytes of this process that are in the machine's memory, after freed ones were given back.
[[nodiscard]] std::size_t resident_bytes();

/// What was added since `before`, a `resident_bytes()`. Nothing where it is too little to be told
/// from what else comes and goes.
[[nodiscard]] std::optional<std::size_t> added_bytes(std::size_t before);

} // namespace abbe::bench
