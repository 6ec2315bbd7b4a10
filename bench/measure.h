#pragma once

#include "bench/command_line.h"
#include "bench/table.h"
#include "bench/write_json.h"

namespace abbe::bench {

/// Measures what the options ask for. `show` gets each result as soon as it is there, `tell` hears
/// what is being done.
[[nodiscard]] Report measure(const Options& options, const std::function<void(const Table&)>& show,
                             const std::function<void(const std::string&)>& tell);

} // namespace abbe::bench
