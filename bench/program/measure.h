#pragma once

#include "bench/program/command_line.h"
#include "bench/reports/table.h"
#include "bench/reports/write_json.h"

namespace abbe::bench {

/// Measures what the options ask for. `show` gets each result as soon as it is there, `tell` hears
/// what is being done.
[[nodiscard]] Report measure(const Options& options, const std::function<void(const Table&)>& show,
                             const std::function<void(const std::string&)>& tell);

} // namespace abbe::bench
