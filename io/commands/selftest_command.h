#pragma once

#include "io/selftest/selftest_row.h"

namespace CLI {
class App;
}

namespace abbe {

/// Prints values that this build computes beside those that closed forms and published tables give.
/// The exit code tells whether all are as expected.
struct SelftestCommand {
  static constexpr const char* kName = "selftest";
  static constexpr const char* kHelp =
      "Check this build against closed forms and published tables of optics and colour";

  bool json = false; ///< in place of the table
};
void add_options(CLI::App& app, SelftestCommand& command);
[[nodiscard]] int run(const SelftestCommand& command);

/// Prints the rows and returns the exit code.
[[nodiscard]] int tell(const SelftestRows& rows, bool json);

} // namespace abbe
