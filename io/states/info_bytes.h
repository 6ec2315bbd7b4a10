#pragma once

#include "io/states/state_info.h"
#include "io/states/value_bytes.h"

namespace abbe {

/// Writes what a file is the state of, and takes it back: the block INFO of docs/state_format.md.
/// Errors: std::runtime_error, for values out of their range.
void put_info(ValueWriter& out, const StateInfo& info);
[[nodiscard]] StateInfo get_info(ValueReader& in);

/// Throws std::runtime_error for a value out of its range in a file that has not been damaged.
void require(bool holds, const char* what);

} // namespace abbe
